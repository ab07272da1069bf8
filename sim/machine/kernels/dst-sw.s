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
    addiu $sp, $sp, -2592
    sdc1 $f30, 2584($sp)
    sdc1 $f28, 2576($sp)
    sdc1 $f26, 2568($sp)
    sdc1 $f24, 2560($sp)
    sdc1 $f22, 2552($sp)
    sdc1 $f20, 2544($sp)
    sw $ra, 2540($sp)
    sw $fp, 2536($sp)
    sw $23, 2532($sp)
    sw $22, 2528($sp)
    sw $21, 2524($sp)
    sw $20, 2520($sp)
    sw $19, 2516($sp)
    sw $18, 2512($sp)
    sw $17, 2508($sp)
    sw $16, 2504($sp)
    addiu $12, $zero, 0
    LOAD $2, $12, 1
    LOAD $4, $12, 8
    LOAD $3, $12, 9
    sw $3, 64($sp)
    ATOMIC_INC $5, 0
    slt $1, $5, $2
    beqz $1, $BB0_82
    sw $2, 8($sp)
    lwc1 $f0, %gp_rel($CPI0_0)($gp)
    lui $1, 32639
    lui $8, 32767
    lui $14, 32640
    addiu $25, $zero, 1
    lui $24, 1024
    lui $16, 53120
    ori $1, $1, 65535
    ori $13, $8, 65535
    swc1 $f0, 80($sp)
    mtc1 $zero, $f0
    sw $1, 36($sp)
    lui $1, 1023
    sw $13, 44($sp)
    ori $15, $1, 65535
    lui $1, 8319
    swc1 $f0, 4($sp)
    lwc1 $f0, %gp_rel($CPI0_1)($gp)
    swc1 $f0, 0($sp)
    lwc1 $f0, %gp_rel($CPI0_2)($gp)
    swc1 $f0, 24($sp)
    lwc1 $f0, %gp_rel($CPI0_3)($gp)
    swc1 $f0, 48($sp)
    j $BB0_4
    ori $17, $1, 65535
$BB0_2:
    lwc1 $f1, 20($sp)
    lwc1 $f2, 16($sp)
    lwc1 $f3, 12($sp)
$BB0_3:
    sll $1, $2, 1
    addu $2, $1, $2
    LOAD $3, $12, 7
    addu $2, $3, $2
    STORE $f3, $2, 0
    STORE $f2, $2, 1
    STORE $f1, $2, 2
    ATOMIC_INC $5, 0
    lw $1, 8($sp)
    slt $1, $5, $1
    beqz $1, $BB0_82
    nop
$BB0_4:
    mtc1 $5, $f0
    LOAD $2, $12, 4
    LOAD $f1, $12, 3
    sw $5, 28($sp)
    cvt.s.w $f0, $f0
    mul.s $f0, $f1, $f0
    trunc.w.s $f0, $f0
    mfc1 $3, $f0
    mul $1, $2, $3
    subu $5, $5, $1
    LOAD $f0, $12, 19
    LOAD $f1, $12, 22
    LOAD $f2, $12, 25
    LOAD $f3, $12, 20
    LOAD $f4, $12, 23
    sra $6, $5, 31
    and $1, $6, $2
    addu $1, $1, $5
    slt $5, $1, $2
    movn $2, $zero, $5
    subu $1, $1, $2
    xori $2, $5, 1
    mtc1 $1, $f7
    LOAD $f8, $12, 26
    lwc1 $f5, 0($sp)
    addu $1, $6, $3
    cvt.s.w $f7, $f7
    addu $1, $1, $2
    mtc1 $1, $f9
    LOAD $f10, $12, 21
    LOAD $f11, $12, 24
    cvt.s.w $f9, $f9
    add.s $f7, $f7, $f5
    add.s $f9, $f9, $f5
    mul.s $f1, $f1, $f7
    mul.s $f4, $f4, $f7
    mul.s $f2, $f2, $f9
    add.s $f0, $f0, $f1
    add.s $f3, $f3, $f4
    LOAD $f1, $12, 27
    LOAD $f15, $12, 16
    LOAD $f16, $12, 17
    LOAD $f17, $12, 18
    mul.s $f1, $f1, $f9
    lui $1, 16256
    sw $1, 116($sp)
    sw $zero, 112($sp)
    sw $zero, 108($sp)
    sw $zero, 104($sp)
    LOAD $2, $12, 2
    sw $2, 32($sp)
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
    lwc1 $f0, 4($sp)
    mul.s $f20, $f3, $f1
    mul.s $f18, $f3, $f2
    swc1 $f0, 20($sp)
    swc1 $f0, 16($sp)
    swc1 $f0, 12($sp)
    lwc1 $f0, 80($sp)
    swc1 $f0, 68($sp)
$BB0_5:
    lwc1 $f21, 24($sp)
    addiu $3, $zero, 1
$BB0_6:
    mfc1 $1, $f19
    and $1, $1, $13
    mtc1 $1, $f2
    mfc1 $1, $f18
    and $1, $1, $13
    mtc1 $1, $f1
    LOAD $5, $12, 10
    lwc1 $f3, 80($sp)
    FPMIN $f0, $f2, $f1
    lwc1 $f4, 48($sp)
    div.s $f23, $f3, $f20
    div.s $f29, $f3, $f18
    div.s $f22, $f3, $f19
    mfc1 $7, $f29
    mfc1 $9, $f22
    mfc1 $6, $f23
    addu $2, $9, $5
    addu $10, $7, $5
    addu $11, $6, $5
    mfc1 $1, $f20
    and $1, $1, $13
    mtc1 $1, $f3
    FPMIN $f0, $f0, $f3
    c.olt.s $f0, $f4
    mtc1 $11, $f28
    mtc1 $10, $f5
    mtc1 $2, $f6
    bc1f $BB0_12
    nop
    beqz $5, $BB0_13
    nop
    mtc1 $zero, $f4
    c.eq.s $f19, $f4
    bc1f $BB0_14
    mov.s $f24, $f22
    c.eq.s $f18, $f4
    bc1f $BB0_15
    mov.s $f25, $f29
$BB0_10:
    c.eq.s $f20, $f4
    bc1f $BB0_16
    nop
$BB0_11:
    mov.s $f28, $f23
    mov.s $f5, $f29
    j $BB0_17
    mov.s $f6, $f22
$BB0_12:
    mov.s $f25, $f29
    j $BB0_17
    mov.s $f24, $f22
$BB0_13:
    mov.s $f25, $f29
    j $BB0_17
    mov.s $f24, $f22
$BB0_14:
    ori $1, $8, 65535
    lui $10, 32640
    and $1, $9, $1
    lw $9, 36($sp)
    sltu $2, $1, $9
    movn $9, $1, $2
    addu $1, $9, $5
    slt $2, $1, $14
    movn $10, $1, $2
    mfc1 $2, $f19
    lui $1, 32768
    and $2, $2, $1
    or $10, $2, $10
    or $2, $2, $9
    mtc1 $10, $f22
    mtc1 $2, $f24
    c.eq.s $f18, $f4
    bc1t $BB0_10
    mov.s $f25, $f29
$BB0_15:
    ori $1, $8, 65535
    lui $9, 32640
    and $1, $7, $1
    lw $7, 36($sp)
    sltu $2, $1, $7
    movn $7, $1, $2
    addu $1, $7, $5
    slt $2, $1, $14
    movn $9, $1, $2
    mfc1 $2, $f18
    lui $1, 32768
    and $2, $2, $1
    or $9, $2, $9
    or $2, $2, $7
    mtc1 $9, $f29
    mtc1 $2, $f25
    c.eq.s $f20, $f4
    bc1t $BB0_11
    nop
$BB0_16:
    ori $1, $8, 65535
    mov.s $f5, $f29
    mov.s $f6, $f22
    and $1, $6, $1
    lw $6, 36($sp)
    sltu $2, $1, $6
    movn $6, $1, $2
    addu $1, $6, $5
    lui $5, 32640
    slt $2, $1, $14
    movn $5, $1, $2
    mfc1 $2, $f20
    lui $1, 32768
    and $2, $2, $1
    or $5, $2, $5
    or $2, $2, $6
    mtc1 $5, $f28
    mtc1 $2, $f23
$BB0_17:
    c.ule.s $f2, $f3
    addiu $1, $zero, 1
    addiu $2, $zero, 1
    addiu $20, $sp, 104
    swc1 $f28, 188($sp)
    swc1 $f5, 184($sp)
    swc1 $f6, 180($sp)
    swc1 $f23, 176($sp)
    swc1 $f25, 172($sp)
    swc1 $f24, 168($sp)
    swc1 $f17, 140($sp)
    swc1 $f16, 136($sp)
    swc1 $f15, 132($sp)
    swc1 $f20, 128($sp)
    swc1 $f18, 124($sp)
    swc1 $f19, 120($sp)
    mtc1 $zero, $f22
    movt $1, $zero, $fcc0
    c.ule.s $f2, $f1
    movt $2, $zero, $fcc0
    c.ule.s $f1, $f3
    and $1, $2, $1
    addiu $2, $zero, 2
    movf $2, $25, $fcc0
    c.olt.s $f24, $f22
    move $5, $2
    addiu $10, $2, -1
    addiu $2, $zero, 2
    movn $5, $zero, $1
    movn $10, $2, $1
    addiu $6, $5, 1
    xori $7, $5, 2
    sll $1, $10, 2
    movz $6, $zero, $7
    sll $7, $5, 2
    addu $11, $1, $20
    sll $9, $6, 2
    addu $7, $20, $7
    lwc1 $f11, 16($11)
    addu $9, $9, $20
    lwc1 $f1, 16($7)
    lwc1 $f4, 16($9)
    LOAD $f0, $12, 40
    LOAD $f2, $12, 41
    LOAD $f7, $12, 42
    LOAD $f3, $12, 43
    mov.s $f8, $f3
    movt.s $f8, $f0, $fcc0
    movt.s $f0, $f3, $fcc0
    c.olt.s $f25, $f22
    sub.s $f8, $f8, $f15
    sub.s $f0, $f0, $f15
    mul.s $f3, $f6, $f8
    LOAD $f8, $12, 44
    mov.s $f9, $f8
    LOAD $f10, $12, 45
    mul.s $f0, $f24, $f0
    movt.s $f9, $f2, $fcc0
    c.olt.s $f23, $f22
    sub.s $f9, $f9, $f16
    mul.s $f9, $f5, $f9
    FPMIN $f3, $f3, $f9
    mov.s $f9, $f10
    movt.s $f9, $f7, $fcc0
    c.olt.s $f25, $f22
    movt.s $f2, $f8, $fcc0
    c.olt.s $f23, $f22
    movt.s $f7, $f10, $fcc0
    sub.s $f9, $f9, $f17
    sub.s $f2, $f2, $f16
    mul.s $f9, $f28, $f9
    FPMIN $f9, $f9, $f21
    FPMIN $f3, $f3, $f9
    mul.s $f2, $f25, $f2
    FPMAX $f0, $f0, $f2
    sub.s $f2, $f7, $f17
    mul.s $f2, $f23, $f2
    FPMAX $f2, $f2, $f22
    FPMAX $f2, $f0, $f2
    c.ule.s $f2, $f3
    andi $1, $3, 1
    bc1f $BB0_74
    sw $1, 92($sp)
    lwc1 $f0, 80($sp)
    div.s $f29, $f11, $f1
    div.s $f31, $f4, $f1
    sll $1, $6, 1
    sll $2, $10, 1
    sll $3, $5, 1
    addiu $14, $zero, 0
    swc1 $f6, 96($sp)
    swc1 $f5, 100($sp)
    swc1 $f30, 52($sp)
    swc1 $f14, 56($sp)
    swc1 $f13, 60($sp)
    addu $ra, $1, $6
    addiu $1, $7, 28
    addu $fp, $2, $10
    addiu $7, $11, 28
    addiu $6, $9, 28
    addu $23, $3, $5
    addiu $11, $zero, -1
    addiu $10, $zero, 0
    move $9, $13
    div.s $f0, $f0, $f1
    sw $1, 72($sp)
    j $BB0_20
    swc1 $f0, 76($sp)
$BB0_19:
    mov.s $f2, $f4
    mov.s $f3, $f1
    c.ole.s $f4, $f1
    bc1f $BB0_60
    move $14, $25
$BB0_20:
    sll $1, $10, 2
    sll $2, $10, 3
    addiu $5, $sp, 200
    negu $12, $10
    addu $1, $2, $1
    addu $19, $5, $1
$BB0_21:
    mov.s $f1, $f3
    addu $25, $14, $4
    LOAD $14, $25, 0
    bltz $14, $BB0_29
    and $21, $14, $15
    and $1, $14, $24
    bnez $1, $BB0_43
    nop
    srl $1, $14, 27
    andi $2, $1, 28
    andi $1, $1, 3
    addu $2, $2, $20
    addu $14, $1, $21
    LOAD $f4, $25, 1
    LOAD $f8, $25, 2
    lwc1 $f9, 28($2)
    lwc1 $f0, 64($2)
    lwc1 $f3, 76($2)
    sub.s $f7, $f4, $f9
    c.olt.s $f0, $f22
    bc1f $BB0_26
    sub.s $f8, $f8, $f9
    mul.s $f0, $f7, $f0
    FPMAX $f4, $f2, $f0
    move $25, $21
    mul.s $f0, $f8, $f3
    FPMIN $f3, $f1, $f0
    c.ole.s $f2, $f3
    bc1t $BB0_27
    nop
    j $BB0_19
    nop
$BB0_26:
    mul.s $f0, $f8, $f0
    move $25, $14
    move $14, $21
    FPMAX $f4, $f2, $f0
    mul.s $f0, $f7, $f3
    FPMIN $f3, $f1, $f0
    c.ole.s $f2, $f3
    bc1f $BB0_19
    nop
$BB0_27:
    c.ole.s $f4, $f1
    bc1f $BB0_21
    nop
    sll $1, $10, 2
    sll $2, $10, 3
    addiu $19, $19, 12
    addiu $12, $12, -1
    addiu $10, $10, 1
    addu $1, $2, $1
    addu $1, $5, $1
    swc1 $f1, 8($1)
    swc1 $f4, 4($1)
    j $BB0_21
    sw $25, 0($1)
$BB0_29:
    LOAD $f4, $25, 1
    LOAD $f3, $25, 2
    srl $5, $14, 27
    srl $25, $14, 29
    andi $3, $25, 3
    addiu $1, $zero, 2
    bne $3, $1, $BB0_33
    andi $2, $5, 3
    sll $1, $2, 2
    addu $1, $1, $20
    lwc1 $f8, 28($1)
    lwc1 $f0, 64($1)
    lwc1 $f7, 76($1)
    sub.s $f4, $f4, $f8
    c.olt.s $f0, $f22
    bc1f $BB0_35
    sub.s $f3, $f3, $f8
    mul.s $f0, $f4, $f0
    FPMAX $f2, $f2, $f0
    mul.s $f0, $f3, $f7
    FPMIN $f3, $f1, $f0
    c.ule.s $f2, $f3
    bc1t $BB0_42
    nop
    j $BB0_60
    nop
$BB0_33:
    srl $1, $3, 1
    srl $2, $2, 1
    sll $1, $1, 2
    addu $3, $1, $20
    lwc1 $f7, 28($3)
    lwc1 $f0, 64($3)
    mfc1 $13, $f0
    srl $1, $13, 31
    bne $1, $2, $BB0_37
    sub.s $f4, $f4, $f7
    lwc1 $f0, 76($3)
    mul.s $f0, $f4, $f0
    FPMIN $f1, $f1, $f0
    j $BB0_38
    nop
$BB0_35:
    mul.s $f0, $f3, $f0
    FPMAX $f2, $f2, $f0
    mul.s $f0, $f4, $f7
    FPMIN $f3, $f1, $f0
    c.ule.s $f2, $f3
    bc1t $BB0_42
    nop
    j $BB0_60
    nop
$BB0_37:
    mul.s $f0, $f0, $f4
    FPMAX $f2, $f2, $f0
$BB0_38:
    andi $1, $25, 1
    andi $3, $5, 1
    sll $1, $1, 2
    addu $2, $20, $1
    lwc1 $f0, 32($2)
    sub.s $f0, $f3, $f0
    lwc1 $f3, 68($2)
    mfc1 $5, $f3
    srl $1, $5, 31
    bne $1, $3, $BB0_41
    nop
    lwc1 $f3, 80($2)
    mul.s $f0, $f0, $f3
    FPMIN $f3, $f1, $f0
    c.ule.s $f2, $f3
    bc1t $BB0_42
    nop
    j $BB0_60
    nop
$BB0_41:
    mul.s $f0, $f3, $f0
    mov.s $f3, $f1
    FPMAX $f2, $f2, $f0
    c.ule.s $f2, $f3
    bc1f $BB0_60
    nop
$BB0_42:
    and $2, $14, $24
    move $14, $21
    beqz $2, $BB0_20
    nop
$BB0_43:
    sll $1, $21, 1
    sll $2, $21, 3
    addu $1, $2, $1
    lw $2, 64($sp)
    addu $21, $1, $2
    lw $1, 72($sp)
    lwc1 $f2, 0($1)
    j $BB0_46
    nop
$BB0_44:
    mov.s $f21, $f4
    lw $1, 92($sp)
    move $9, $5
    move $11, $21
    swc1 $f1, 152($sp)
    swc1 $f3, 148($sp)
    swc1 $f1, 88($sp)
    beqz $1, $BB0_71
    swc1 $f3, 84($sp)
$BB0_45:
    lui $1, 2048
    and $1, $10, $1
    bnez $1, $BB0_60
    addiu $21, $21, 10
$BB0_46:
    addu $2, $ra, $21
    lwc1 $f3, 0($6)
    lwc1 $f0, 0($7)
    LOAD $f1, $2, 0
    LOAD $f4, $2, 1
    LOAD $f7, $2, 2
    ori $14, $8, 65535
    addu $2, $fp, $21
    LOAD $f8, $2, 0
    LOAD $f9, $2, 1
    LOAD $f11, $2, 2
    sub.s $f10, $f1, $f3
    addu $2, $23, $21
    LOAD $f1, $2, 0
    sub.s $f4, $f4, $f3
    sub.s $f7, $f7, $f3
    LOAD $f3, $2, 1
    sub.s $f8, $f8, $f0
    sub.s $f9, $f9, $f0
    sub.s $f0, $f11, $f0
    sub.s $f1, $f1, $f2
    sub.s $f3, $f3, $f2
    mfc1 $13, $f4
    mfc1 $5, $f9
    mfc1 $3, $f10
    mfc1 $25, $f7
    mul.s $f12, $f29, $f1
    and $3, $3, $14
    sub.s $f14, $f8, $f12
    mul.s $f12, $f31, $f3
    sub.s $f4, $f4, $f12
    mul.s $f12, $f29, $f3
    mfc1 $10, $f14
    and $10, $10, $14
    mtc1 $10, $f30
    sub.s $f9, $f9, $f12
    mul.s $f12, $f31, $f1
    mfc1 $1, $f4
    and $1, $1, $14
    mtc1 $1, $f13
    LOAD $f6, $2, 2
    mfc1 $2, $f0
    sub.s $f10, $f10, $f12
    mfc1 $22, $f9
    mfc1 $1, $f8
    and $22, $22, $14
    and $1, $1, $14
    mtc1 $1, $f8
    and $1, $5, $14
    mtc1 $22, $f5
    and $5, $13, $14
    and $13, $25, $14
    mfc1 $18, $f10
    mtc1 $1, $f26
    FPMAX $f5, $f30, $f5
    FPMAX $f8, $f8, $f26
    LOAD $10, $21, 9
    mtc1 $3, $f26
    and $18, $18, $14
    mtc1 $18, $f12
    FPMAX $f30, $f12, $f13
    sub.s $f13, $f6, $f2
    mul.s $f6, $f31, $f13
    mul.s $f11, $f29, $f13
    sub.s $f6, $f7, $f6
    sub.s $f0, $f0, $f11
    mul.s $f7, $f14, $f6
    mul.s $f11, $f10, $f0
    mfc1 $1, $f6
    mfc1 $3, $f0
    mul.s $f12, $f4, $f0
    mul.s $f27, $f9, $f6
    mul.s $f0, $f10, $f9
    mul.s $f4, $f14, $f4
    and $3, $3, $14
    and $1, $1, $14
    mtc1 $3, $f6
    sub.s $f11, $f11, $f7
    mtc1 $1, $f7
    and $1, $2, $14
    mfc1 $2, $f1
    sub.s $f12, $f27, $f12
    sub.s $f4, $f4, $f0
    mtc1 $1, $f9
    FPMAX $f14, $f30, $f7
    FPMAX $f5, $f5, $f6
    FPMAX $f6, $f8, $f9
    FPMIN $f10, $f12, $f11
    FPMAX $f7, $f12, $f11
    mtc1 $13, $f8
    mfc1 $1, $f3
    and $2, $2, $14
    mtc1 $5, $f9
    mtc1 $2, $f0
    and $1, $1, $14
    mtc1 $1, $f27
    FPMAX $f0, $f0, $f27
    mfc1 $1, $f13
    and $1, $1, $14
    mtc1 $1, $f27
    FPMAX $f0, $f0, $f27
    FPMAX $f14, $f14, $f5
    FPMAX $f5, $f26, $f9
    FPMAX $f7, $f7, $f4
    FPMIN $f9, $f10, $f4
    FPMAX $f0, $f6, $f0
    FPMAX $f5, $f5, $f8
    FPMAX $f8, $f5, $f0
    mfc1 $2, $f8
    addu $1, $2, $16
    sltu $1, $17, $1
    bnez $1, $BB0_53
    nop
    lwc1 $f10, %gp_rel($CPI0_5)($gp)
    lwc1 $f0, %gp_rel($CPI0_4)($gp)
    mul.s $f5, $f8, $f10
    mul.s $f0, $f8, $f0
    add.s $f5, $f5, $f14
    mul.s $f14, $f0, $f5
    c.ule.s $f7, $f14
    bc1t $BB0_49
    neg.s $f0, $f14
    c.olt.s $f9, $f0
    bc1t $BB0_45
    nop
$BB0_49:
    c.ule.s $f9, $f14
    bc1f $BB0_51
    nop
    c.olt.s $f7, $f0
    bc1f $BB0_53
    nop
$BB0_51:
    mul.s $f0, $f3, $f11
    mul.s $f1, $f1, $f12
    neg.s $f5, $f9
    lwc1 $f3, %gp_rel($CPI0_6)($gp)
    FPMAX $f5, $f7, $f5
    mul.s $f5, $f5, $f10
    mul.s $f3, $f8, $f3
    add.s $f0, $f1, $f0
    mul.s $f1, $f13, $f4
    add.s $f5, $f14, $f5
    add.s $f0, $f1, $f0
    mul.s $f3, $f3, $f5
    mfc1 $1, $f0
    and $1, $1, $14
    mtc1 $1, $f1
    c.ule.s $f1, $f3
    bc1t $BB0_53
    nop
    lwc1 $f1, 76($sp)
    lwc1 $f3, 80($sp)
    mul.s $f0, $f1, $f0
    add.s $f1, $f12, $f11
    add.s $f1, $f4, $f1
    div.s $f3, $f3, $f1
    mul.s $f12, $f3, $f0
    mul.s $f1, $f4, $f3
    j $BB0_54
    mul.s $f3, $f11, $f3
$BB0_53:
    EXACT $2, $f12, $f3, $f1, $21, $f15, $f16, $f17, $f19, $f18, $f20
    beqz $2, $BB0_45
    nop
$BB0_54:
    LOAD $f0, $21, 0
    LOAD $f4, $21, 1
    FPMAX $f13, $f0, $f4
    LOAD $f5, $21, 2
    c.olt.s $f24, $f22
    LOAD $f6, $21, 3
    LOAD $f7, $21, 4
    LOAD $f8, $21, 5
    LOAD $f9, $21, 6
    LOAD $f10, $21, 7
    LOAD $f11, $21, 8
    FPMIN $f0, $f0, $f4
    FPMAX $f13, $f13, $f5
    mov.s $f4, $f13
    FPMIN $f0, $f0, $f5
    lwc1 $f5, 96($sp)
    movt.s $f4, $f0, $fcc0
    movt.s $f0, $f13, $fcc0
    c.olt.s $f25, $f22
    sub.s $f4, $f4, $f15
    sub.s $f0, $f0, $f15
    mul.s $f4, $f5, $f4
    FPMAX $f5, $f6, $f7
    FPMIN $f6, $f6, $f7
    mul.s $f0, $f24, $f0
    FPMAX $f5, $f5, $f8
    mov.s $f7, $f5
    FPMIN $f6, $f6, $f8
    lwc1 $f8, 100($sp)
    movt.s $f7, $f6, $fcc0
    c.olt.s $f23, $f22
    sub.s $f7, $f7, $f16
    mul.s $f7, $f8, $f7
    FPMIN $f4, $f4, $f7
    FPMIN $f8, $f9, $f10
    FPMAX $f7, $f9, $f10
    FPMIN $f8, $f8, $f11
    FPMAX $f7, $f7, $f11
    mov.s $f9, $f7
    movt.s $f9, $f8, $fcc0
    c.olt.s $f25, $f22
    movt.s $f6, $f5, $fcc0
    c.olt.s $f23, $f22
    sub.s $f9, $f9, $f17
    movt.s $f8, $f7, $fcc0
    mul.s $f9, $f28, $f9
    FPMIN $f9, $f4, $f9
    sub.s $f4, $f6, $f16
    mul.s $f4, $f25, $f4
    FPMAX $f0, $f0, $f4
    sub.s $f4, $f8, $f17
    mul.s $f4, $f23, $f4
    FPMAX $f0, $f0, $f4
    c.ule.s $f0, $f9
    FPMAX $f4, $f12, $f0
    FPMIN $f4, $f4, $f9
    bc1f $BB0_45
    nop
    c.olt.s $f4, $f22
    bc1t $BB0_45
    nop
    c.ule.s $f4, $f21
    bc1f $BB0_45
    nop
    c.ult.s $f4, $f21
    bc1t $BB0_44
    and $5, $10, $15
    slt $1, $5, $9
    beqz $1, $BB0_45
    nop
    j $BB0_44
    nop
$BB0_60:
    addiu $25, $zero, 1
$BB0_61:
    addiu $12, $12, 1
    beq $12, $25, $BB0_64
    nop
    lwc1 $f2, -8($19)
    addiu $2, $19, -12
    c.ule.s $f2, $f21
    bc1f $BB0_61
    move $19, $2
    lw $14, 0($2)
    lwc1 $f0, 8($2)
    negu $10, $12
    FPMIN $f3, $f0, $f21
    j $BB0_20
    nop
$BB0_64:
    lw $1, 92($sp)
    beqz $1, $BB0_72
    nop
    bltz $11, $BB0_80
    nop
    LOAD $f1, $11, 0
    LOAD $f26, $11, 1
    sub.s $f15, $f26, $f1
    LOAD $f25, $11, 2
    LOAD $f2, $11, 3
    LOAD $f11, $11, 4
    sub.s $f17, $f11, $f2
    LOAD $f28, $11, 5
    ori $3, $8, 65535
    sub.s $f3, $f28, $f2
    sub.s $f21, $f25, $f1
    lui $14, 32640
    lwc1 $f0, %gp_rel($CPI0_7)($gp)
    mfc1 $2, $f15
    mfc1 $1, $f17
    and $2, $2, $3
    and $1, $1, $3
    mtc1 $2, $f4
    mtc1 $1, $f5
    LOAD $f16, $11, 6
    LOAD $f27, $11, 7
    LOAD $f12, $11, 8
    sub.s $f24, $f27, $f16
    mfc1 $2, $f21
    sub.s $f23, $f12, $f16
    FPMAX $f4, $f4, $f5
    mfc1 $1, $f3
    and $2, $2, $3
    mtc1 $2, $f5
    and $1, $1, $3
    mtc1 $1, $f6
    mfc1 $1, $f24
    and $1, $1, $3
    mtc1 $1, $f7
    FPMAX $f4, $f4, $f7
    FPMAX $f5, $f5, $f6
    mfc1 $1, $f23
    and $1, $1, $3
    mtc1 $1, $f6
    FPMAX $f5, $f5, $f6
    FPMAX $f4, $f4, $f5
    mfc1 $2, $f4
    and $1, $2, $14
    lui $2, 32512
    subu $2, $2, $1
    mtc1 $2, $f5
    mul.s $f6, $f23, $f5
    mul.s $f8, $f15, $f5
    mul.s $f9, $f21, $f5
    mul.s $f7, $f24, $f5
    mul.s $f13, $f3, $f5
    mul.s $f5, $f17, $f5
    mul.s $f4, $f8, $f6
    mul.s $f10, $f7, $f9
    mul.s $f7, $f7, $f13
    mul.s $f8, $f8, $f13
    mul.s $f6, $f5, $f6
    mul.s $f5, $f5, $f9
    sub.s $f4, $f10, $f4
    sub.s $f7, $f6, $f7
    sub.s $f8, $f8, $f5
    mul.s $f10, $f4, $f4
    mul.s $f6, $f7, $f7
    mul.s $f5, $f8, $f8
    add.s $f6, $f6, $f10
    add.s $f9, $f5, $f6
    c.ult.s $f9, $f0
    bc1f $BB0_68
    nop
    neg.s $f13, $f20
    neg.s $f14, $f18
    neg.s $f30, $f19
    lw $13, 44($sp)
    j $BB0_69
    addiu $12, $zero, 0
$BB0_68:
    mul.s $f0, $f18, $f4
    mul.s $f5, $f19, $f7
    lui $6, 32768
    lw $13, 44($sp)
    addiu $12, $zero, 0
    add.s $f0, $f5, $f0
    mul.s $f5, $f20, $f8
    add.s $f0, $f5, $f0
    mfc1 $2, $f0
    FPINVSQRT $f0, $f9
    and $2, $2, $6
    mfc1 $5, $f0
    xor $1, $5, $2
    xor $2, $1, $6
    mtc1 $2, $f0
    mul.s $f13, $f8, $f0
    mul.s $f14, $f4, $f0
    mul.s $f30, $f7, $f0
$BB0_69:
    mfc1 $1, $f2
    mfc1 $9, $f1
    mfc1 $6, $f12
    mfc1 $10, $f26
    lwc1 $f7, %gp_rel($CPI0_8)($gp)
    lwc1 $f12, 68($sp)
    mfc1 $2, $f11
    lwc1 $f10, 84($sp)
    mfc1 $5, $f16
    mfc1 $7, $f28
    swc1 $f13, 164($sp)
    swc1 $f14, 160($sp)
    swc1 $f30, 156($sp)
    and $1, $1, $3
    and $9, $9, $3
    and $10, $10, $3
    mul.s $f12, $f12, $f7
    and $2, $2, $3
    and $5, $5, $3
    and $6, $6, $3
    and $7, $7, $3
    mtc1 $1, $f0
    mfc1 $1, $f27
    mtc1 $9, $f8
    mtc1 $10, $f9
    mtc1 $2, $f4
    mfc1 $2, $f25
    mtc1 $5, $f5
    and $1, $1, $3
    and $2, $2, $3
    mtc1 $1, $f6
    FPMAX $f7, $f8, $f9
    mul.s $f8, $f15, $f10
    FPMAX $f0, $f0, $f4
    mtc1 $6, $f4
    FPMAX $f5, $f5, $f6
    swc1 $f12, 116($sp)
    mtc1 $7, $f6
    FPMAX $f0, $f0, $f6
    FPMAX $f4, $f5, $f4
    mtc1 $2, $f5
    LOAD $f9, $12, 28
    FPMAX $f0, $f0, $f4
    FPMAX $f4, $f7, $f5
    LOAD $f7, $12, 29
    lwc1 $f11, 88($sp)
    mul.s $f6, $f17, $f10
    mul.s $f5, $f24, $f10
    FPMAX $f0, $f4, $f0
    add.s $f1, $f1, $f8
    lwc1 $f8, %gp_rel($CPI0_9)($gp)
    mul.s $f10, $f21, $f11
    mul.s $f3, $f3, $f11
    mul.s $f0, $f0, $f8
    add.s $f2, $f2, $f6
    add.s $f5, $f16, $f5
    mul.s $f6, $f23, $f11
    LOAD $f11, $12, 30
    add.s $f1, $f1, $f10
    mul.s $f4, $f30, $f0
    mul.s $f8, $f14, $f0
    add.s $f2, $f2, $f3
    mul.s $f0, $f13, $f0
    add.s $f15, $f4, $f1
    add.s $f16, $f8, $f2
    sub.s $f1, $f9, $f15
    sub.s $f3, $f7, $f16
    mfc1 $1, $f1
    and $1, $1, $3
    mtc1 $1, $f4
    mfc1 $1, $f3
    and $1, $1, $3
    mtc1 $1, $f2
    FPMAX $f2, $f4, $f2
    add.s $f4, $f5, $f6
    add.s $f17, $f0, $f4
    sub.s $f0, $f11, $f17
    mfc1 $1, $f0
    and $1, $1, $3
    mtc1 $1, $f4
    FPMAX $f2, $f2, $f4
    mfc1 $2, $f2
    and $5, $2, $14
    lui $1, 32512
    subu $2, $1, $5
    mtc1 $2, $f2
    mul.s $f18, $f3, $f2
    mul.s $f19, $f1, $f2
    mul.s $f20, $f0, $f2
    mul.s $f3, $f14, $f18
    mul.s $f1, $f30, $f19
    mul.s $f0, $f13, $f20
    add.s $f1, $f1, $f3
    add.s $f1, $f0, $f1
    c.ule.s $f1, $f22
    bc1t $BB0_78
    nop
    addiu $3, $zero, 0
    LOAD $f0, $3, 11
    mul.s $f3, $f19, $f19
    swc1 $f12, 68($sp)
    mtc1 $5, $f21
    mul.s $f0, $f2, $f0
    mul.s $f2, $f18, $f18
    add.s $f2, $f3, $f2
    mul.s $f3, $f20, $f20
    add.s $f2, $f3, $f2
    lwc1 $f3, %gp_rel($CPI0_10)($gp)
    FPINVSQRT $f2, $f2
    mul.s $f0, $f2, $f0
    mul.s $f3, $f12, $f3
    mul.s $f1, $f3, $f1
    mul.s $f1, $f1, $f2
    mul.s $f1, $f1, $f0
    mul.s $f0, $f0, $f1
    swc1 $f0, 40($sp)
    j $BB0_6
    swc1 $f0, 144($sp)
$BB0_71:
    swc1 $f1, 88($sp)
    swc1 $f3, 84($sp)
    move $11, $21
    addiu $25, $zero, 1
$BB0_72:
    lw $2, 28($sp)
    lw $13, 44($sp)
    lwc1 $f13, 60($sp)
    lwc1 $f14, 56($sp)
    lwc1 $f30, 52($sp)
    lw $3, 32($sp)
    lwc1 $f12, 68($sp)
    addiu $12, $zero, 0
    bgez $11, $BB0_76
    lui $14, 32640
    j $BB0_75
    nop
$BB0_74:
    lw $2, 28($sp)
    lw $3, 32($sp)
    lwc1 $f12, 68($sp)
    lw $1, 92($sp)
    bnez $1, $BB0_81
    nop
$BB0_75:
    LOAD $f0, $12, 31
    lwc1 $f1, 40($sp)
    lwc1 $f2, 12($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 12($sp)
    swc1 $f2, 104($sp)
    LOAD $f0, $12, 32
    lwc1 $f2, 16($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 16($sp)
    swc1 $f2, 108($sp)
    LOAD $f0, $12, 33
    mul.s $f0, $f1, $f0
    lwc1 $f1, 20($sp)
    add.s $f1, $f1, $f0
    swc1 $f1, 20($sp)
    swc1 $f1, 112($sp)
$BB0_76:
    beqz $3, $BB0_2
    nop
$BB0_77:
    swc1 $f12, 68($sp)
    RAND $f0
    RAND $f1
    mfc1 $2, $f13
    lwc1 $f2, %gp_rel($CPI0_11)($gp)
    lwc1 $f6, %gp_rel($CPI0_12)($gp)
    lwc1 $f11, 80($sp)
    mul.s $f7, $f14, $f14
    addiu $3, $3, -1
    lui $1, 32768
    sw $3, 32($sp)
    and $1, $2, $1
    lui $2, 16256
    mul.s $f1, $f1, $f2
    sub.s $f3, $f11, $f0
    sqrt.s $f0, $f0
    or $2, $1, $2
    mtc1 $2, $f2
    add.s $f4, $f13, $f2
    SIN $f5, $f1
    COS $f1, $f1
    sqrt.s $f3, $f3
    div.s $f4, $f6, $f4
    mul.s $f6, $f30, $f14
    mul.s $f5, $f0, $f5
    mul.s $f0, $f0, $f1
    mul.s $f8, $f3, $f13
    mul.s $f9, $f3, $f30
    mul.s $f3, $f3, $f14
    mul.s $f7, $f7, $f4
    mul.s $f6, $f6, $f4
    add.s $f7, $f2, $f7
    mul.s $f10, $f2, $f6
    mul.s $f2, $f30, $f2
    mul.s $f6, $f5, $f6
    mul.s $f7, $f5, $f7
    mul.s $f1, $f0, $f10
    add.s $f1, $f1, $f7
    mul.s $f7, $f30, $f2
    mul.s $f4, $f7, $f4
    add.s $f18, $f3, $f1
    add.s $f4, $f4, $f11
    mul.s $f4, $f0, $f4
    mul.s $f0, $f0, $f2
    add.s $f1, $f6, $f4
    sub.s $f0, $f8, $f0
    add.s $f19, $f9, $f1
    mul.s $f1, $f5, $f14
    j $BB0_5
    sub.s $f20, $f0, $f1
$BB0_78:
    lw $2, 28($sp)
    lw $3, 32($sp)
    bnez $3, $BB0_77
    nop
    j $BB0_2
    nop
$BB0_80:
    lw $2, 28($sp)
    lw $13, 44($sp)
    lwc1 $f13, 60($sp)
    lwc1 $f14, 56($sp)
    lwc1 $f30, 52($sp)
    lwc1 $f12, 68($sp)
    addiu $12, $zero, 0
    lui $14, 32640
$BB0_81:
    LOAD $f0, $12, 34
    lwc1 $f3, 12($sp)
    mul.s $f0, $f12, $f0
    add.s $f3, $f3, $f0
    swc1 $f3, 104($sp)
    LOAD $f0, $12, 35
    lwc1 $f2, 16($sp)
    mul.s $f0, $f12, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 108($sp)
    LOAD $f0, $12, 36
    lwc1 $f1, 20($sp)
    mul.s $f0, $f12, $f0
    add.s $f1, $f1, $f0
    j $BB0_3
    swc1 $f1, 112($sp)
$BB0_82:
    lw $16, 2504($sp)
    lw $17, 2508($sp)
    lw $18, 2512($sp)
    lw $19, 2516($sp)
    lw $20, 2520($sp)
    lw $21, 2524($sp)
    lw $22, 2528($sp)
    lw $23, 2532($sp)
    lw $fp, 2536($sp)
    lw $ra, 2540($sp)
    ldc1 $f20, 2544($sp)
    ldc1 $f22, 2552($sp)
    ldc1 $f24, 2560($sp)
    ldc1 $f26, 2568($sp)
    ldc1 $f28, 2576($sp)
    ldc1 $f30, 2584($sp)
    addiu $2, $zero, 0
    jr $ra
    addiu $sp, $sp, 2592
