$CPI0_0:
    .4byte 0x3f800000
$CPI0_1:
    .4byte 0x3f000000
$CPI0_2:
    .4byte 0x7f800000
$CPI0_3:
    .4byte 0x00800000
$CPI0_4:
    .4byte 0x36200000
$CPI0_5:
    .4byte 0x34800000
$CPI0_6:
    .4byte 0x40800000
$CPI0_7:
    .4byte 0x2f800000
$CPI0_8:
    .4byte 0x3f333333
$CPI0_9:
    .4byte 0x37000000
$CPI0_10:
    .4byte 0x3ea2f983
$CPI0_11:
    .4byte 0x40c90fdb
$CPI0_12:
    .4byte 0xbf800000
main:
    addiu $sp, $sp, -2632
    sdc1 $f30, 2624($sp)
    sdc1 $f28, 2616($sp)
    sdc1 $f26, 2608($sp)
    sdc1 $f24, 2600($sp)
    sdc1 $f22, 2592($sp)
    sdc1 $f20, 2584($sp)
    sw $ra, 2580($sp)
    sw $fp, 2576($sp)
    sw $23, 2572($sp)
    sw $22, 2568($sp)
    sw $21, 2564($sp)
    sw $20, 2560($sp)
    sw $19, 2556($sp)
    sw $18, 2552($sp)
    sw $17, 2548($sp)
    sw $16, 2544($sp)
    addiu $25, $zero, 0
    LOAD $2, $25, 1
    LOAD $4, $25, 8
    LOAD $3, $25, 9
    sw $3, 92($sp)
    ATOMIC_INC $3, 0
    slt $1, $3, $2
    beqz $1, $BB0_86
    sw $2, 12($sp)
    lwc1 $f0, %gp_rel($CPI0_0)($gp)
    lui $8, 32767
    mtc1 $zero, $f27
    addiu $16, $zero, 1
    lui $24, 1024
    lui $17, 53120
    ori $1, $8, 65535
    swc1 $f0, 120($sp)
    mtc1 $zero, $f0
    sw $1, 108($sp)
    lui $1, 32639
    ori $1, $1, 65535
    swc1 $f0, 8($sp)
    lwc1 $f0, %gp_rel($CPI0_1)($gp)
    sw $1, 40($sp)
    lui $1, 1023
    ori $15, $1, 65535
    lui $1, 8319
    swc1 $f0, 4($sp)
    lwc1 $f0, %gp_rel($CPI0_2)($gp)
    swc1 $f0, 28($sp)
    lwc1 $f0, %gp_rel($CPI0_3)($gp)
    swc1 $f0, 84($sp)
    j $BB0_4
    ori $18, $1, 65535
$BB0_2:
    lwc1 $f1, 24($sp)
    lwc1 $f2, 20($sp)
    lwc1 $f3, 16($sp)
$BB0_3:
    sll $1, $2, 1
    swc1 $f22, 100($sp)
    swc1 $f12, 88($sp)
    swc1 $f23, 104($sp)
    addu $2, $1, $2
    LOAD $3, $25, 7
    addu $2, $3, $2
    STORE $f3, $2, 0
    STORE $f2, $2, 1
    STORE $f1, $2, 2
    ATOMIC_INC $3, 0
    lw $1, 12($sp)
    slt $1, $3, $1
    beqz $1, $BB0_86
    nop
$BB0_4:
    mtc1 $3, $f0
    LOAD $2, $25, 4
    LOAD $f1, $25, 3
    move $5, $3
    sw $5, 32($sp)
    cvt.s.w $f0, $f0
    mul.s $f0, $f1, $f0
    trunc.w.s $f0, $f0
    mfc1 $3, $f0
    mul $1, $2, $3
    subu $5, $5, $1
    LOAD $f0, $25, 19
    LOAD $f1, $25, 22
    LOAD $f2, $25, 25
    LOAD $f3, $25, 20
    LOAD $f4, $25, 23
    sra $6, $5, 31
    and $1, $6, $2
    addu $1, $1, $5
    slt $5, $1, $2
    movn $2, $zero, $5
    subu $1, $1, $2
    xori $2, $5, 1
    mtc1 $1, $f7
    LOAD $f8, $25, 26
    lwc1 $f5, 4($sp)
    addu $1, $6, $3
    cvt.s.w $f7, $f7
    addu $1, $1, $2
    mtc1 $1, $f9
    LOAD $f10, $25, 21
    LOAD $f11, $25, 24
    cvt.s.w $f9, $f9
    add.s $f7, $f7, $f5
    add.s $f9, $f9, $f5
    mul.s $f1, $f1, $f7
    mul.s $f4, $f4, $f7
    mul.s $f2, $f2, $f9
    add.s $f0, $f0, $f1
    add.s $f3, $f3, $f4
    LOAD $f1, $25, 27
    LOAD $f15, $25, 16
    LOAD $f16, $25, 17
    LOAD $f17, $25, 18
    mul.s $f1, $f1, $f9
    lui $1, 16256
    sw $1, 156($sp)
    sw $zero, 152($sp)
    sw $zero, 148($sp)
    sw $zero, 144($sp)
    LOAD $2, $25, 2
    sw $2, 36($sp)
    add.s $f0, $f2, $f0
    mul.s $f2, $f8, $f9
    add.s $f2, $f2, $f3
    mul.s $f4, $f0, $f0
    mul.s $f3, $f2, $f2
    add.s $f3, $f4, $f3
    mul.s $f4, $f11, $f7
    add.s $f4, $f10, $f4
    add.s $f1, $f1, $f4
    mul.s $f4, $f1, $f1
    add.s $f3, $f4, $f3
    FPINVSQRT $f3, $f3
    mul.s $f19, $f3, $f0
    lwc1 $f0, 8($sp)
    mul.s $f20, $f3, $f1
    mul.s $f18, $f3, $f2
    swc1 $f0, 24($sp)
    swc1 $f0, 20($sp)
    swc1 $f0, 16($sp)
    lwc1 $f0, 120($sp)
    swc1 $f0, 96($sp)
$BB0_5:
    lwc1 $f4, 28($sp)
    addiu $1, $zero, 1
    sw $1, 132($sp)
$BB0_6:
    mfc1 $1, $f20
    lw $3, 108($sp)
    mfc1 $2, $f18
    lwc1 $f0, 120($sp)
    addiu $fp, $sp, 144
    and $1, $1, $3
    and $2, $2, $3
    div.s $f5, $f0, $f20
    div.s $f6, $f0, $f18
    div.s $f7, $f0, $f19
    mtc1 $1, $f1
    mfc1 $1, $f19
    mtc1 $2, $f3
    addiu $2, $zero, 1
    and $1, $1, $3
    addiu $3, $zero, 2
    swc1 $f1, 80($sp)
    swc1 $f3, 72($sp)
    mtc1 $1, $f2
    addiu $1, $zero, 1
    c.ule.s $f2, $f1
    swc1 $f2, 76($sp)
    movt $1, $zero, $fcc0
    c.ule.s $f2, $f3
    movt $2, $zero, $fcc0
    c.ule.s $f3, $f1
    and $1, $2, $1
    addiu $2, $zero, 2
    movf $2, $16, $fcc0
    swc1 $f5, 68($sp)
    swc1 $f6, 64($sp)
    swc1 $f7, 60($sp)
    addiu $5, $2, -1
    movn $2, $zero, $1
    movn $5, $3, $1
    addiu $1, $2, 1
    xori $3, $2, 2
    sll $6, $2, 1
    movz $1, $zero, $3
    sll $3, $5, 1
    addu $ra, $6, $2
    sll $2, $2, 2
    addu $3, $3, $5
    sll $5, $5, 2
    sll $6, $1, 2
    addu $2, $2, $fp
    addu $9, $6, $fp
    sll $6, $1, 1
    addu $5, $5, $fp
    addiu $19, $2, 16
    addu $7, $6, $1
    addiu $20, $9, 16
    addiu $1, $2, 28
    addiu $21, $5, 16
    addiu $6, $5, 28
    addiu $14, $9, 28
    sw $19, 56($sp)
    sw $1, 112($sp)
    sw $20, 52($sp)
    sw $21, 48($sp)
$BB0_7:
    FPMIN $f0, $f2, $f3
    LOAD $5, $25, 10
    mfc1 $11, $f6
    addu $10, $11, $5
    mfc1 $2, $f7
    mfc1 $9, $f5
    addu $12, $9, $5
    mtc1 $12, $f24
    FPMIN $f0, $f0, $f1
    mtc1 $10, $f1
    swc1 $f1, 136($sp)
    addu $10, $2, $5
    mtc1 $10, $f1
    swc1 $f1, 140($sp)
    lwc1 $f1, 84($sp)
    c.olt.s $f0, $f1
    bc1f $BB0_13
    nop
    mov.s $f2, $f5
    mov.s $f31, $f6
    beqz $5, $BB0_17
    mov.s $f29, $f7
    mtc1 $zero, $f1
    mov.s $f29, $f7
    c.eq.s $f19, $f1
    bc1f $BB0_14
    swc1 $f7, 140($sp)
    mov.s $f31, $f6
    c.eq.s $f18, $f1
    bc1f $BB0_15
    swc1 $f6, 136($sp)
$BB0_11:
    c.eq.s $f20, $f1
    bc1f $BB0_16
    nop
$BB0_12:
    mov.s $f24, $f5
    j $BB0_17
    mov.s $f2, $f5
$BB0_13:
    mov.s $f2, $f5
    mov.s $f31, $f6
    j $BB0_17
    mov.s $f29, $f7
$BB0_14:
    ori $1, $8, 65535
    lw $10, 40($sp)
    lui $12, 32640
    and $1, $2, $1
    sltu $2, $1, $10
    movn $10, $1, $2
    lui $2, 32640
    addu $1, $10, $5
    slt $2, $1, $2
    movn $12, $1, $2
    mfc1 $2, $f19
    lui $1, 32768
    and $2, $2, $1
    or $12, $2, $12
    mtc1 $12, $f0
    or $2, $2, $10
    mtc1 $2, $f29
    swc1 $f0, 140($sp)
    mov.s $f31, $f6
    c.eq.s $f18, $f1
    bc1t $BB0_11
    swc1 $f6, 136($sp)
$BB0_15:
    ori $1, $8, 65535
    lw $10, 40($sp)
    and $1, $11, $1
    lui $11, 32640
    sltu $2, $1, $10
    movn $10, $1, $2
    lui $2, 32640
    addu $1, $10, $5
    slt $2, $1, $2
    movn $11, $1, $2
    mfc1 $2, $f18
    lui $1, 32768
    and $2, $2, $1
    or $11, $2, $11
    mtc1 $11, $f0
    or $2, $2, $10
    mtc1 $2, $f31
    c.eq.s $f20, $f1
    bc1t $BB0_12
    swc1 $f0, 136($sp)
$BB0_16:
    ori $1, $8, 65535
    and $1, $9, $1
    lw $9, 40($sp)
    sltu $2, $1, $9
    movn $9, $1, $2
    lui $2, 32640
    addu $1, $9, $5
    lui $5, 32640
    slt $2, $1, $2
    movn $5, $1, $2
    mfc1 $2, $f20
    lui $1, 32768
    and $2, $2, $1
    or $5, $2, $5
    or $2, $2, $9
    mtc1 $5, $f24
    mtc1 $2, $f2
$BB0_17:
    lwc1 $f6, 136($sp)
    lwc1 $f5, 140($sp)
    swc1 $f24, 228($sp)
    c.olt.s $f31, $f27
    swc1 $f6, 224($sp)
    swc1 $f5, 220($sp)
    swc1 $f2, 216($sp)
    swc1 $f31, 212($sp)
    swc1 $f29, 208($sp)
    swc1 $f17, 180($sp)
    swc1 $f16, 176($sp)
    swc1 $f15, 172($sp)
    swc1 $f20, 168($sp)
    swc1 $f18, 164($sp)
    swc1 $f19, 160($sp)
    lwc1 $f1, 0($20)
    lwc1 $f8, 0($21)
    lwc1 $f9, 0($19)
    LOAD $f0, $25, 40
    LOAD $f3, $25, 41
    LOAD $f7, $25, 42
    LOAD $f10, $25, 43
    LOAD $f11, $25, 44
    mov.s $f12, $f11
    mov.s $f13, $f10
    movt.s $f12, $f3, $fcc0
    c.olt.s $f29, $f27
    movt.s $f13, $f0, $fcc0
    c.olt.s $f29, $f27
    sub.s $f12, $f12, $f16
    movt.s $f0, $f10, $fcc0
    c.olt.s $f2, $f27
    sub.s $f13, $f13, $f15
    mul.s $f10, $f6, $f12
    LOAD $f12, $25, 45
    sub.s $f0, $f0, $f15
    mul.s $f13, $f5, $f13
    FPMIN $f10, $f13, $f10
    mov.s $f13, $f12
    mul.s $f0, $f29, $f0
    movt.s $f13, $f7, $fcc0
    c.olt.s $f31, $f27
    movt.s $f3, $f11, $fcc0
    c.olt.s $f2, $f27
    movt.s $f7, $f12, $fcc0
    sub.s $f13, $f13, $f17
    sub.s $f3, $f3, $f16
    mul.s $f13, $f24, $f13
    FPMIN $f13, $f13, $f4
    FPMIN $f10, $f10, $f13
    mul.s $f3, $f31, $f3
    FPMAX $f0, $f0, $f3
    sub.s $f3, $f7, $f17
    mul.s $f3, $f2, $f3
    FPMAX $f3, $f3, $f27
    FPMAX $f7, $f0, $f3
    c.ule.s $f7, $f10
    bc1f $BB0_77
    nop
    lwc1 $f0, 120($sp)
    div.s $f11, $f8, $f9
    div.s $f12, $f1, $f9
    mov.s $f8, $f4
    mov.s $f4, $f10
    lw $9, 108($sp)
    addiu $22, $zero, -1
    addiu $25, $zero, 0
    addiu $20, $zero, 0
    div.s $f0, $f0, $f9
    swc1 $f0, 116($sp)
$BB0_19:
    move $16, $13
    move $21, $25
$BB0_20:
    sll $1, $20, 2
    sll $2, $20, 3
    addiu $25, $sp, 240
    negu $11, $20
    addu $1, $2, $1
    addu $5, $25, $1
$BB0_21:
    mov.s $f13, $f4
    addu $2, $21, $4
    LOAD $12, $2, 0
    bltz $12, $BB0_31
    and $13, $12, $15
    and $1, $12, $24
    bnez $1, $BB0_45
    nop
    srl $1, $12, 27
    andi $10, $1, 28
    andi $1, $1, 3
    addu $10, $10, $fp
    addu $21, $1, $13
    LOAD $f1, $2, 1
    LOAD $f10, $2, 2
    lwc1 $f14, 28($10)
    lwc1 $f0, 64($10)
    lwc1 $f4, 76($10)
    sub.s $f9, $f1, $f14
    c.olt.s $f0, $f27
    bc1f $BB0_26
    sub.s $f10, $f10, $f14
    mul.s $f0, $f9, $f0
    FPMAX $f1, $f7, $f0
    move $2, $13
    mul.s $f0, $f10, $f4
    FPMIN $f4, $f13, $f0
    c.ole.s $f7, $f4
    bc1t $BB0_27
    nop
    j $BB0_29
    nop
$BB0_26:
    mul.s $f0, $f10, $f0
    move $2, $21
    move $21, $13
    FPMAX $f1, $f7, $f0
    mul.s $f0, $f9, $f4
    FPMIN $f4, $f13, $f0
    c.ole.s $f7, $f4
    bc1f $BB0_29
    nop
$BB0_27:
    c.ole.s $f1, $f13
    bc1f $BB0_21
    nop
    sll $1, $20, 2
    sll $10, $20, 3
    addiu $5, $5, 12
    addiu $11, $11, -1
    addiu $20, $20, 1
    addu $1, $10, $1
    addu $1, $25, $1
    swc1 $f13, 8($1)
    swc1 $f1, 4($1)
    j $BB0_21
    sw $2, 0($1)
$BB0_29:
    mov.s $f7, $f1
    mov.s $f4, $f13
    c.ole.s $f1, $f13
    bc1t $BB0_20
    move $21, $2
    move $13, $16
    j $BB0_63
    addiu $16, $zero, 1
$BB0_31:
    LOAD $f4, $2, 1
    LOAD $f1, $2, 2
    srl $25, $12, 27
    srl $2, $12, 29
    andi $10, $2, 3
    addiu $1, $zero, 2
    bne $10, $1, $BB0_34
    andi $23, $25, 3
    sll $1, $23, 2
    addu $1, $1, $fp
    lwc1 $f10, 28($1)
    lwc1 $f0, 64($1)
    lwc1 $f9, 76($1)
    sub.s $f4, $f4, $f10
    c.olt.s $f0, $f27
    bc1f $BB0_36
    sub.s $f1, $f1, $f10
    mul.s $f0, $f4, $f0
    FPMAX $f7, $f7, $f0
    mul.s $f0, $f1, $f9
    FPMIN $f4, $f13, $f0
    j $BB0_41
    nop
$BB0_34:
    srl $1, $10, 1
    sll $1, $1, 2
    addu $10, $1, $fp
    lwc1 $f9, 28($10)
    lwc1 $f0, 64($10)
    mfc1 $19, $f0
    srl $1, $19, 31
    srl $19, $23, 1
    bne $1, $19, $BB0_37
    sub.s $f4, $f4, $f9
    lwc1 $f0, 76($10)
    mul.s $f0, $f4, $f0
    FPMIN $f13, $f13, $f0
    j $BB0_38
    nop
$BB0_36:
    mul.s $f0, $f1, $f0
    FPMAX $f7, $f7, $f0
    mul.s $f0, $f4, $f9
    FPMIN $f4, $f13, $f0
    j $BB0_41
    nop
$BB0_37:
    mul.s $f0, $f0, $f4
    FPMAX $f7, $f7, $f0
$BB0_38:
    andi $1, $2, 1
    andi $10, $25, 1
    sll $1, $1, 2
    addu $2, $fp, $1
    lwc1 $f0, 32($2)
    sub.s $f0, $f1, $f0
    lwc1 $f1, 68($2)
    mfc1 $25, $f1
    srl $1, $25, 31
    bne $1, $10, $BB0_40
    nop
    lwc1 $f1, 80($2)
    mul.s $f0, $f0, $f1
    FPMIN $f4, $f13, $f0
    j $BB0_41
    nop
$BB0_40:
    mov.s $f4, $f13
    mul.s $f0, $f1, $f0
    FPMAX $f7, $f7, $f0
$BB0_41:
    c.ule.s $f7, $f4
    and $1, $12, $24
    move $25, $13
    movz $13, $16, $1
    srl $1, $1, 23
    movf $25, $21, $fcc0
    movf $13, $16, $fcc0
    c.ule.s $f7, $f4
    xori $2, $1, 8
    addiu $1, $zero, 10
    movf $2, $1, $fcc0
    addiu $1, $zero, 8
    beq $2, $1, $BB0_19
    nop
$BB0_42:
    beqz $2, $BB0_45
    addiu $16, $zero, 1
$BB0_43:
    addiu $1, $zero, 10
    beq $2, $1, $BB0_63
    nop
$BB0_44:
    j $BB0_66
    nop
$BB0_45:
    sll $1, $13, 1
    sll $2, $13, 3
    addu $1, $2, $1
    lw $2, 92($sp)
    addu $13, $1, $2
    lw $1, 112($sp)
    lwc1 $f13, 0($1)
    j $BB0_48
    nop
$BB0_46:
    mov.s $f8, $f1
    lw $1, 132($sp)
    move $9, $2
    move $22, $13
    swc1 $f4, 192($sp)
    swc1 $f7, 188($sp)
    swc1 $f4, 128($sp)
    andi $1, $1, 1
    beqz $1, $BB0_74
    swc1 $f7, 124($sp)
$BB0_47:
    lui $1, 2048
    and $1, $20, $1
    bnez $1, $BB0_62
    addiu $13, $13, 10
$BB0_48:
    addu $2, $7, $13
    lwc1 $f1, 0($14)
    lwc1 $f0, 0($6)
    LOAD $f4, $2, 0
    LOAD $f7, $2, 1
    LOAD $f9, $2, 2
    ori $16, $8, 65535
    addu $2, $3, $13
    LOAD $f10, $2, 0
    LOAD $f14, $2, 1
    LOAD $f23, $2, 2
    sub.s $f21, $f4, $f1
    addu $2, $ra, $13
    LOAD $f4, $2, 0
    sub.s $f22, $f7, $f1
    sub.s $f10, $f10, $f0
    sub.s $f9, $f9, $f1
    LOAD $f1, $2, 1
    sub.s $f14, $f14, $f0
    sub.s $f0, $f23, $f0
    sub.s $f4, $f4, $f13
    mfc1 $25, $f22
    mfc1 $12, $f14
    mfc1 $10, $f21
    mfc1 $21, $f9
    mul.s $f7, $f11, $f4
    and $10, $10, $16
    sub.s $f25, $f10, $f7
    sub.s $f7, $f1, $f13
    mul.s $f1, $f12, $f7
    mfc1 $19, $f25
    and $19, $19, $16
    mtc1 $19, $f3
    sub.s $f22, $f22, $f1
    mul.s $f1, $f11, $f7
    sub.s $f14, $f14, $f1
    mul.s $f1, $f12, $f4
    mfc1 $1, $f22
    and $1, $1, $16
    mtc1 $1, $f26
    LOAD $f6, $2, 2
    mfc1 $2, $f0
    sub.s $f21, $f21, $f1
    mfc1 $20, $f14
    mfc1 $1, $f10
    and $20, $20, $16
    and $1, $1, $16
    mtc1 $1, $f10
    and $1, $12, $16
    mtc1 $20, $f5
    and $12, $25, $16
    and $25, $21, $16
    mfc1 $23, $f21
    mtc1 $1, $f28
    FPMAX $f3, $f3, $f5
    FPMAX $f23, $f10, $f28
    LOAD $20, $13, 9
    mtc1 $10, $f28
    and $23, $23, $16
    mtc1 $23, $f1
    FPMAX $f5, $f1, $f26
    sub.s $f1, $f6, $f13
    mul.s $f6, $f12, $f1
    mul.s $f10, $f11, $f1
    sub.s $f6, $f9, $f6
    sub.s $f0, $f0, $f10
    mfc1 $1, $f6
    mfc1 $10, $f0
    mul.s $f9, $f25, $f6
    mul.s $f26, $f21, $f0
    mul.s $f10, $f22, $f0
    mul.s $f30, $f14, $f6
    mul.s $f0, $f21, $f14
    mul.s $f6, $f25, $f22
    and $1, $1, $16
    and $10, $10, $16
    mtc1 $1, $f21
    and $1, $2, $16
    mtc1 $10, $f14
    mfc1 $2, $f4
    mtc1 $1, $f22
    sub.s $f10, $f30, $f10
    sub.s $f9, $f26, $f9
    FPMAX $f5, $f5, $f21
    FPMAX $f3, $f3, $f14
    FPMAX $f14, $f23, $f22
    FPMIN $f25, $f10, $f9
    sub.s $f21, $f6, $f0
    mtc1 $25, $f23
    mtc1 $12, $f30
    FPMAX $f22, $f10, $f9
    and $2, $2, $16
    mfc1 $1, $f7
    mtc1 $2, $f0
    and $1, $1, $16
    mtc1 $1, $f6
    FPMAX $f0, $f0, $f6
    mfc1 $1, $f1
    and $1, $1, $16
    mtc1 $1, $f6
    FPMAX $f0, $f0, $f6
    FPMAX $f26, $f5, $f3
    FPMAX $f3, $f28, $f30
    FPMAX $f22, $f22, $f21
    FPMAX $f3, $f3, $f23
    FPMAX $f0, $f14, $f0
    FPMAX $f14, $f3, $f0
    FPMIN $f23, $f25, $f21
    mfc1 $2, $f14
    addu $1, $2, $17
    sltu $1, $18, $1
    bnez $1, $BB0_55
    nop
    lwc1 $f25, %gp_rel($CPI0_5)($gp)
    lwc1 $f0, %gp_rel($CPI0_4)($gp)
    mul.s $f3, $f14, $f25
    mul.s $f0, $f14, $f0
    add.s $f3, $f3, $f26
    mul.s $f26, $f0, $f3
    c.ule.s $f22, $f26
    bc1t $BB0_51
    neg.s $f0, $f26
    c.olt.s $f23, $f0
    bc1t $BB0_47
    nop
$BB0_51:
    c.ule.s $f23, $f26
    bc1f $BB0_53
    nop
    c.olt.s $f22, $f0
    bc1f $BB0_55
    nop
$BB0_53:
    mul.s $f3, $f4, $f10
    mul.s $f0, $f7, $f9
    lwc1 $f4, %gp_rel($CPI0_6)($gp)
    mul.s $f1, $f1, $f21
    add.s $f0, $f3, $f0
    mul.s $f3, $f14, $f4
    neg.s $f4, $f23
    FPMAX $f4, $f22, $f4
    mul.s $f4, $f4, $f25
    add.s $f0, $f1, $f0
    add.s $f4, $f26, $f4
    mfc1 $1, $f0
    mul.s $f3, $f3, $f4
    and $1, $1, $16
    mtc1 $1, $f1
    c.ule.s $f1, $f3
    bc1t $BB0_55
    nop
    lwc1 $f1, 116($sp)
    lwc1 $f3, 120($sp)
    mul.s $f0, $f1, $f0
    add.s $f1, $f10, $f9
    add.s $f1, $f21, $f1
    div.s $f3, $f3, $f1
    mul.s $f1, $f3, $f0
    mul.s $f4, $f21, $f3
    j $BB0_56
    mul.s $f7, $f9, $f3
$BB0_55:
    EXACT $2, $f1, $f7, $f4, $13, $f15, $f16, $f17, $f19, $f18, $f20
    beqz $2, $BB0_47
    nop
$BB0_56:
    LOAD $f0, $13, 0
    LOAD $f3, $13, 1
    FPMAX $f23, $f0, $f3
    LOAD $f5, $13, 2
    c.olt.s $f29, $f27
    LOAD $f6, $13, 3
    LOAD $f9, $13, 4
    LOAD $f10, $13, 5
    LOAD $f14, $13, 6
    LOAD $f21, $13, 7
    LOAD $f22, $13, 8
    FPMIN $f0, $f0, $f3
    FPMAX $f23, $f23, $f5
    mov.s $f3, $f23
    FPMIN $f0, $f0, $f5
    lwc1 $f5, 140($sp)
    movt.s $f3, $f0, $fcc0
    movt.s $f0, $f23, $fcc0
    c.olt.s $f31, $f27
    sub.s $f3, $f3, $f15
    sub.s $f0, $f0, $f15
    mul.s $f3, $f5, $f3
    FPMAX $f5, $f6, $f9
    FPMIN $f6, $f6, $f9
    mul.s $f0, $f29, $f0
    FPMAX $f5, $f5, $f10
    mov.s $f9, $f5
    FPMIN $f6, $f6, $f10
    lwc1 $f10, 136($sp)
    movt.s $f9, $f6, $fcc0
    c.olt.s $f2, $f27
    sub.s $f9, $f9, $f16
    mul.s $f9, $f10, $f9
    FPMIN $f3, $f3, $f9
    FPMIN $f10, $f14, $f21
    FPMAX $f9, $f14, $f21
    FPMIN $f10, $f10, $f22
    FPMAX $f9, $f9, $f22
    mov.s $f14, $f9
    movt.s $f14, $f10, $fcc0
    c.olt.s $f31, $f27
    movt.s $f6, $f5, $fcc0
    c.olt.s $f2, $f27
    movt.s $f10, $f9, $fcc0
    sub.s $f14, $f14, $f17
    sub.s $f5, $f6, $f16
    mul.s $f14, $f24, $f14
    FPMIN $f3, $f3, $f14
    mul.s $f5, $f31, $f5
    FPMAX $f0, $f0, $f5
    sub.s $f5, $f10, $f17
    mul.s $f5, $f2, $f5
    FPMAX $f0, $f0, $f5
    c.ule.s $f0, $f3
    FPMAX $f1, $f1, $f0
    FPMIN $f1, $f1, $f3
    bc1f $BB0_47
    nop
    c.olt.s $f1, $f27
    bc1t $BB0_47
    nop
    c.ule.s $f1, $f8
    bc1f $BB0_47
    nop
    c.ult.s $f1, $f8
    bc1t $BB0_46
    and $2, $20, $15
    slt $1, $2, $9
    beqz $1, $BB0_47
    nop
    j $BB0_46
    nop
$BB0_62:
    addiu $13, $13, -10
    addiu $16, $zero, 1
$BB0_63:
    addiu $11, $11, 1
    beq $11, $16, $BB0_67
    nop
    lwc1 $f7, -8($5)
    addiu $2, $5, -12
    c.ule.s $f7, $f8
    bc1f $BB0_63
    move $5, $2
    lw $25, 0($2)
    lwc1 $f0, 8($2)
    negu $20, $11
    FPMIN $f4, $f0, $f8
    j $BB0_19
    nop
$BB0_66:
    lwc1 $f1, 80($sp)
    lwc1 $f2, 76($sp)
    lwc1 $f3, 72($sp)
    lwc1 $f5, 68($sp)
    lwc1 $f6, 64($sp)
    lwc1 $f7, 60($sp)
    lw $19, 56($sp)
    lw $20, 52($sp)
    lw $21, 48($sp)
    j $BB0_7
    addiu $25, $zero, 0
$BB0_67:
    lw $1, 132($sp)
    andi $1, $1, 1
    beqz $1, $BB0_79
    nop
    lwc1 $f23, 104($sp)
    lwc1 $f22, 100($sp)
    bltz $22, $BB0_84
    nop
    LOAD $f1, $22, 0
    LOAD $f16, $22, 1
    sub.s $f4, $f16, $f1
    LOAD $f15, $22, 2
    LOAD $f2, $22, 3
    LOAD $f9, $22, 4
    sub.s $f8, $f9, $f2
    LOAD $f21, $22, 5
    ori $3, $8, 65535
    sub.s $f3, $f21, $f2
    sub.s $f11, $f15, $f1
    lwc1 $f0, %gp_rel($CPI0_7)($gp)
    mfc1 $2, $f4
    mfc1 $1, $f8
    and $2, $2, $3
    and $1, $1, $3
    mtc1 $2, $f5
    mtc1 $1, $f6
    LOAD $f7, $22, 6
    LOAD $f17, $22, 7
    LOAD $f10, $22, 8
    sub.s $f13, $f17, $f7
    mfc1 $2, $f11
    FPMAX $f5, $f5, $f6
    mfc1 $1, $f3
    and $2, $2, $3
    mtc1 $2, $f6
    and $1, $1, $3
    mtc1 $1, $f12
    mfc1 $1, $f13
    and $1, $1, $3
    mtc1 $1, $f14
    FPMAX $f6, $f6, $f12
    sub.s $f12, $f10, $f7
    FPMAX $f5, $f5, $f14
    mfc1 $1, $f12
    and $1, $1, $3
    mtc1 $1, $f14
    FPMAX $f6, $f6, $f14
    FPMAX $f5, $f5, $f6
    mfc1 $2, $f5
    lui $1, 32640
    and $1, $2, $1
    lui $2, 32512
    subu $2, $2, $1
    mtc1 $2, $f5
    mul.s $f6, $f12, $f5
    mul.s $f23, $f4, $f5
    mul.s $f24, $f11, $f5
    mul.s $f22, $f13, $f5
    mul.s $f26, $f3, $f5
    mul.s $f5, $f8, $f5
    mul.s $f14, $f23, $f6
    mul.s $f25, $f22, $f24
    mul.s $f22, $f22, $f26
    mul.s $f23, $f23, $f26
    mul.s $f6, $f5, $f6
    mul.s $f5, $f5, $f24
    sub.s $f14, $f25, $f14
    sub.s $f22, $f6, $f22
    sub.s $f23, $f23, $f5
    mul.s $f25, $f14, $f14
    mul.s $f6, $f22, $f22
    mul.s $f5, $f23, $f23
    add.s $f6, $f6, $f25
    add.s $f24, $f5, $f6
    c.ult.s $f24, $f0
    bc1f $BB0_71
    nop
    neg.s $f23, $f20
    neg.s $f20, $f18
    neg.s $f22, $f19
    j $BB0_72
    addiu $25, $zero, 0
$BB0_71:
    mul.s $f0, $f18, $f14
    mul.s $f5, $f19, $f22
    lui $6, 32768
    addiu $25, $zero, 0
    add.s $f0, $f5, $f0
    mul.s $f5, $f20, $f23
    add.s $f0, $f5, $f0
    mfc1 $2, $f0
    FPINVSQRT $f0, $f24
    and $2, $2, $6
    mfc1 $5, $f0
    xor $1, $5, $2
    xor $2, $1, $6
    mtc1 $2, $f0
    mul.s $f23, $f23, $f0
    mul.s $f20, $f14, $f0
    mul.s $f22, $f22, $f0
$BB0_72:
    mfc1 $1, $f2
    mfc1 $9, $f1
    mfc1 $2, $f9
    mfc1 $10, $f16
    mfc1 $6, $f10
    mfc1 $7, $f21
    lwc1 $f10, %gp_rel($CPI0_8)($gp)
    lwc1 $f21, 96($sp)
    mfc1 $5, $f7
    swc1 $f23, 204($sp)
    swc1 $f20, 200($sp)
    swc1 $f22, 196($sp)
    and $1, $1, $3
    and $9, $9, $3
    and $2, $2, $3
    and $10, $10, $3
    mul.s $f21, $f21, $f10
    and $5, $5, $3
    and $6, $6, $3
    and $7, $7, $3
    mtc1 $1, $f0
    mfc1 $1, $f17
    mtc1 $9, $f14
    mtc1 $2, $f5
    mfc1 $2, $f15
    mtc1 $10, $f15
    mtc1 $5, $f6
    and $1, $1, $3
    and $2, $2, $3
    mtc1 $1, $f9
    FPMAX $f10, $f14, $f15
    lwc1 $f14, 124($sp)
    FPMAX $f6, $f6, $f9
    FPMAX $f0, $f0, $f5
    mtc1 $6, $f5
    swc1 $f21, 156($sp)
    mtc1 $7, $f9
    FPMAX $f0, $f0, $f9
    FPMAX $f5, $f6, $f5
    mtc1 $2, $f6
    mul.s $f4, $f4, $f14
    FPMAX $f0, $f0, $f5
    FPMAX $f5, $f10, $f6
    mul.s $f6, $f13, $f14
    LOAD $f9, $25, 28
    LOAD $f10, $25, 29
    lwc1 $f13, 128($sp)
    mul.s $f8, $f8, $f14
    FPMAX $f0, $f5, $f0
    mul.s $f11, $f11, $f13
    mul.s $f3, $f3, $f13
    add.s $f1, $f1, $f4
    lwc1 $f4, %gp_rel($CPI0_9)($gp)
    add.s $f2, $f2, $f8
    add.s $f6, $f7, $f6
    LOAD $f7, $25, 30
    mul.s $f8, $f12, $f13
    swc1 $f20, 88($sp)
    mul.s $f0, $f0, $f4
    add.s $f1, $f1, $f11
    add.s $f2, $f2, $f3
    mul.s $f4, $f22, $f0
    mul.s $f5, $f20, $f0
    mul.s $f0, $f23, $f0
    add.s $f15, $f4, $f1
    add.s $f16, $f5, $f2
    sub.s $f1, $f9, $f15
    sub.s $f3, $f10, $f16
    mfc1 $1, $f1
    and $1, $1, $3
    mtc1 $1, $f4
    mfc1 $1, $f3
    and $1, $1, $3
    mtc1 $1, $f2
    FPMAX $f2, $f4, $f2
    add.s $f4, $f6, $f8
    add.s $f17, $f0, $f4
    sub.s $f0, $f7, $f17
    mfc1 $1, $f0
    and $1, $1, $3
    mtc1 $1, $f4
    FPMAX $f2, $f2, $f4
    mfc1 $2, $f2
    lui $1, 32640
    and $2, $2, $1
    lui $1, 32512
    subu $3, $1, $2
    mtc1 $3, $f2
    mul.s $f18, $f3, $f2
    mul.s $f19, $f1, $f2
    mul.s $f3, $f20, $f18
    mul.s $f1, $f22, $f19
    mul.s $f20, $f0, $f2
    add.s $f1, $f1, $f3
    mul.s $f0, $f23, $f20
    add.s $f1, $f0, $f1
    c.ule.s $f1, $f27
    bc1t $BB0_82
    nop
    addiu $1, $zero, 0
    swc1 $f22, 100($sp)
    swc1 $f23, 104($sp)
    addiu $3, $zero, 0
    mul.s $f3, $f19, $f19
    sw $1, 132($sp)
    mtc1 $2, $f4
    LOAD $f0, $3, 11
    swc1 $f21, 96($sp)
    mul.s $f0, $f2, $f0
    mul.s $f2, $f18, $f18
    add.s $f2, $f3, $f2
    mul.s $f3, $f20, $f20
    add.s $f2, $f3, $f2
    lwc1 $f3, %gp_rel($CPI0_10)($gp)
    FPINVSQRT $f2, $f2
    mul.s $f0, $f2, $f0
    mul.s $f3, $f21, $f3
    mul.s $f1, $f3, $f1
    mul.s $f1, $f1, $f2
    mul.s $f1, $f1, $f0
    mul.s $f0, $f0, $f1
    swc1 $f0, 44($sp)
    j $BB0_6
    swc1 $f0, 184($sp)
$BB0_74:
    lw $2, 32($sp)
    lwc1 $f23, 104($sp)
    lwc1 $f22, 100($sp)
    lw $3, 36($sp)
    lwc1 $f21, 96($sp)
    swc1 $f4, 128($sp)
    swc1 $f7, 124($sp)
    move $22, $13
    lwc1 $f12, 88($sp)
    bltz $22, $BB0_80
    addiu $16, $zero, 1
$BB0_75:
    bnez $3, $BB0_81
    addiu $25, $zero, 0
    j $BB0_2
    nop
$BB0_77:
    lw $1, 132($sp)
    lw $2, 32($sp)
    lwc1 $f23, 104($sp)
    lwc1 $f12, 88($sp)
    lwc1 $f22, 100($sp)
    lw $3, 36($sp)
    lwc1 $f21, 96($sp)
    andi $1, $1, 1
    beqz $1, $BB0_80
    nop
    j $BB0_85
    nop
$BB0_79:
    lw $2, 32($sp)
    lwc1 $f23, 104($sp)
    lwc1 $f22, 100($sp)
    lw $3, 36($sp)
    lwc1 $f21, 96($sp)
    lwc1 $f12, 88($sp)
    bgez $22, $BB0_75
    nop
$BB0_80:
    addiu $25, $zero, 0
    LOAD $f0, $25, 31
    lwc1 $f1, 44($sp)
    lwc1 $f2, 16($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 16($sp)
    swc1 $f2, 144($sp)
    LOAD $f0, $25, 32
    lwc1 $f2, 20($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 20($sp)
    swc1 $f2, 148($sp)
    LOAD $f0, $25, 33
    mul.s $f0, $f1, $f0
    lwc1 $f1, 24($sp)
    add.s $f1, $f1, $f0
    swc1 $f1, 24($sp)
    beqz $3, $BB0_2
    swc1 $f1, 152($sp)
$BB0_81:
    swc1 $f21, 96($sp)
    RAND $f0
    RAND $f1
    mfc1 $2, $f23
    lwc1 $f2, %gp_rel($CPI0_11)($gp)
    lwc1 $f6, %gp_rel($CPI0_12)($gp)
    lwc1 $f11, 120($sp)
    mul.s $f7, $f12, $f12
    addiu $3, $3, -1
    swc1 $f23, 104($sp)
    swc1 $f22, 100($sp)
    swc1 $f12, 88($sp)
    lui $1, 32768
    sw $3, 36($sp)
    and $1, $2, $1
    lui $2, 16256
    mul.s $f1, $f1, $f2
    sub.s $f3, $f11, $f0
    sqrt.s $f0, $f0
    or $2, $1, $2
    mtc1 $2, $f2
    add.s $f4, $f23, $f2
    SIN $f5, $f1
    COS $f1, $f1
    sqrt.s $f3, $f3
    div.s $f4, $f6, $f4
    mul.s $f6, $f22, $f12
    mul.s $f5, $f0, $f5
    mul.s $f0, $f0, $f1
    mul.s $f8, $f3, $f23
    mul.s $f9, $f3, $f22
    mul.s $f3, $f3, $f12
    mul.s $f7, $f7, $f4
    mul.s $f6, $f6, $f4
    add.s $f7, $f2, $f7
    mul.s $f10, $f2, $f6
    mul.s $f2, $f22, $f2
    mul.s $f6, $f5, $f6
    mul.s $f7, $f5, $f7
    mul.s $f1, $f0, $f10
    add.s $f1, $f1, $f7
    mul.s $f7, $f22, $f2
    mul.s $f4, $f7, $f4
    add.s $f18, $f3, $f1
    add.s $f4, $f4, $f11
    mul.s $f4, $f0, $f4
    mul.s $f0, $f0, $f2
    add.s $f1, $f6, $f4
    sub.s $f0, $f8, $f0
    add.s $f19, $f9, $f1
    mul.s $f1, $f5, $f12
    j $BB0_5
    sub.s $f20, $f0, $f1
$BB0_82:
    lw $2, 32($sp)
    lwc1 $f12, 88($sp)
    lw $3, 36($sp)
    bnez $3, $BB0_81
    nop
    j $BB0_2
    nop
$BB0_84:
    lw $2, 32($sp)
    lwc1 $f12, 88($sp)
    lwc1 $f21, 96($sp)
$BB0_85:
    addiu $25, $zero, 0
    LOAD $f0, $25, 34
    lwc1 $f3, 16($sp)
    mul.s $f0, $f21, $f0
    add.s $f3, $f3, $f0
    swc1 $f3, 144($sp)
    LOAD $f0, $25, 35
    lwc1 $f2, 20($sp)
    mul.s $f0, $f21, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 148($sp)
    LOAD $f0, $25, 36
    lwc1 $f1, 24($sp)
    mul.s $f0, $f21, $f0
    add.s $f1, $f1, $f0
    j $BB0_3
    swc1 $f1, 152($sp)
$BB0_86:
    lw $16, 2544($sp)
    lw $17, 2548($sp)
    lw $18, 2552($sp)
    lw $19, 2556($sp)
    lw $20, 2560($sp)
    lw $21, 2564($sp)
    lw $22, 2568($sp)
    lw $23, 2572($sp)
    lw $fp, 2576($sp)
    lw $ra, 2580($sp)
    ldc1 $f20, 2584($sp)
    ldc1 $f22, 2592($sp)
    ldc1 $f24, 2600($sp)
    ldc1 $f26, 2608($sp)
    ldc1 $f28, 2616($sp)
    ldc1 $f30, 2624($sp)
    addiu $2, $zero, 0
    jr $ra
    addiu $sp, $sp, 2632
