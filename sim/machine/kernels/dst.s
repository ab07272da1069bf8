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
    addiu $14, $zero, 0
    LOAD $2, $14, 1
    LOAD $4, $14, 8
    LOAD $3, $14, 9
    sw $3, 44($sp)
    ATOMIC_INC $6, 0
    slt $1, $6, $2
    beqz $1, $BB0_63
    sw $2, 8($sp)
    lwc1 $f0, %gp_rel($CPI0_0)($gp)
    lui $1, 32639
    lui $8, 32767
    lui $19, 32640
    addiu $13, $zero, 1
    lui $24, 53120
    ori $1, $1, 65535
    ori $17, $8, 65535
    swc1 $f0, 80($sp)
    mtc1 $zero, $f0
    sw $1, 36($sp)
    lui $1, 8319
    sw $17, 48($sp)
    ori $25, $1, 65535
    lui $1, 1023
    swc1 $f0, 4($sp)
    lwc1 $f0, %gp_rel($CPI0_1)($gp)
    ori $1, $1, 65535
    sw $1, 92($sp)
    swc1 $f0, 0($sp)
    lwc1 $f0, %gp_rel($CPI0_2)($gp)
    swc1 $f0, 12($sp)
    lwc1 $f0, %gp_rel($CPI0_3)($gp)
    swc1 $f0, 52($sp)
    j $BB0_4
    lui $16, 2048
$BB0_2:
    lwc1 $f1, 24($sp)
    lwc1 $f2, 20($sp)
    lwc1 $f3, 16($sp)
$BB0_3:
    sll $1, $2, 1
    addu $2, $1, $2
    LOAD $3, $14, 7
    addu $2, $3, $2
    STORE $f3, $2, 0
    STORE $f2, $2, 1
    STORE $f1, $2, 2
    ATOMIC_INC $6, 0
    lw $1, 8($sp)
    slt $1, $6, $1
    beqz $1, $BB0_63
    nop
$BB0_4:
    mtc1 $6, $f0
    LOAD $3, $14, 4
    LOAD $f1, $14, 3
    sw $6, 28($sp)
    cvt.s.w $f0, $f0
    mul.s $f0, $f1, $f0
    trunc.w.s $f0, $f0
    mfc1 $5, $f0
    mul $1, $3, $5
    subu $6, $6, $1
    LOAD $f0, $14, 19
    LOAD $f1, $14, 22
    LOAD $f2, $14, 25
    LOAD $f3, $14, 20
    LOAD $f4, $14, 23
    sra $9, $6, 31
    and $1, $9, $3
    addu $1, $1, $6
    slt $6, $1, $3
    movn $3, $zero, $6
    subu $1, $1, $3
    xori $3, $6, 1
    mtc1 $1, $f7
    LOAD $f8, $14, 26
    lwc1 $f5, 0($sp)
    addu $1, $9, $5
    cvt.s.w $f7, $f7
    addu $1, $1, $3
    mtc1 $1, $f9
    LOAD $f10, $14, 21
    LOAD $f11, $14, 24
    cvt.s.w $f9, $f9
    add.s $f7, $f7, $f5
    add.s $f9, $f9, $f5
    mul.s $f1, $f1, $f7
    mul.s $f4, $f4, $f7
    mul.s $f2, $f2, $f9
    add.s $f0, $f0, $f1
    add.s $f3, $f3, $f4
    LOAD $f1, $14, 27
    LOAD $f15, $14, 16
    LOAD $f16, $14, 17
    LOAD $f17, $14, 18
    mul.s $f1, $f1, $f9
    lui $1, 16256
    sw $1, 116($sp)
    sw $zero, 112($sp)
    sw $zero, 108($sp)
    sw $zero, 104($sp)
    LOAD $2, $14, 2
    lwc1 $f19, 80($sp)
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
    mul.s $f6, $f3, $f0
    mul.s $f5, $f3, $f1
    mul.s $f20, $f3, $f2
    lwc1 $f0, 4($sp)
    swc1 $f0, 24($sp)
    swc1 $f0, 20($sp)
    swc1 $f0, 16($sp)
$BB0_5:
    lwc1 $f21, 12($sp)
    addiu $3, $zero, 1
$BB0_6:
    mfc1 $1, $f6
    and $1, $1, $17
    mtc1 $1, $f22
    mfc1 $1, $f20
    and $1, $1, $17
    mtc1 $1, $f2
    LOAD $5, $14, 10
    lwc1 $f1, 80($sp)
    FPMIN $f0, $f22, $f2
    lwc1 $f4, 52($sp)
    swc1 $f19, 72($sp)
    div.s $f23, $f1, $f5
    div.s $f29, $f1, $f20
    div.s $f3, $f1, $f6
    mfc1 $9, $f29
    mfc1 $12, $f3
    mfc1 $6, $f23
    addu $10, $12, $5
    addu $11, $9, $5
    addu $15, $6, $5
    mfc1 $1, $f5
    and $1, $1, $17
    mtc1 $1, $f1
    FPMIN $f0, $f0, $f1
    c.olt.s $f0, $f4
    mtc1 $15, $f26
    mtc1 $11, $f27
    mtc1 $10, $f28
    bc1f $BB0_12
    nop
    beqz $5, $BB0_13
    nop
    mtc1 $zero, $f4
    c.eq.s $f6, $f4
    bc1f $BB0_14
    mov.s $f24, $f3
    c.eq.s $f20, $f4
    bc1f $BB0_15
    mov.s $f25, $f29
$BB0_10:
    c.eq.s $f5, $f4
    bc1f $BB0_16
    nop
$BB0_11:
    mov.s $f26, $f23
    mov.s $f27, $f29
    j $BB0_17
    mov.s $f28, $f3
$BB0_12:
    mov.s $f25, $f29
    j $BB0_17
    mov.s $f24, $f3
$BB0_13:
    mov.s $f25, $f29
    j $BB0_17
    mov.s $f24, $f3
$BB0_14:
    ori $1, $8, 65535
    lw $11, 36($sp)
    and $1, $12, $1
    lui $12, 32640
    sltu $10, $1, $11
    movn $11, $1, $10
    addu $1, $11, $5
    slt $10, $1, $19
    movn $12, $1, $10
    mfc1 $10, $f6
    lui $1, 32768
    and $10, $10, $1
    or $12, $10, $12
    or $10, $10, $11
    mtc1 $12, $f3
    mtc1 $10, $f24
    c.eq.s $f20, $f4
    bc1t $BB0_10
    mov.s $f25, $f29
$BB0_15:
    ori $1, $8, 65535
    lw $10, 36($sp)
    lui $11, 32640
    and $1, $9, $1
    sltu $9, $1, $10
    movn $10, $1, $9
    addu $1, $10, $5
    slt $9, $1, $19
    movn $11, $1, $9
    mfc1 $9, $f20
    lui $1, 32768
    and $9, $9, $1
    or $11, $9, $11
    or $9, $9, $10
    mtc1 $11, $f29
    mtc1 $9, $f25
    c.eq.s $f5, $f4
    bc1t $BB0_11
    nop
$BB0_16:
    ori $1, $8, 65535
    lw $9, 36($sp)
    mov.s $f27, $f29
    mov.s $f28, $f3
    and $1, $6, $1
    sltu $6, $1, $9
    movn $9, $1, $6
    lui $6, 32640
    addu $1, $9, $5
    slt $5, $1, $19
    movn $6, $1, $5
    mfc1 $5, $f5
    lui $1, 32768
    and $5, $5, $1
    or $6, $5, $6
    or $5, $5, $9
    mtc1 $6, $f26
    mtc1 $5, $f23
$BB0_17:
    c.ule.s $f22, $f1
    addiu $1, $zero, 1
    addiu $5, $zero, 1
    addiu $10, $zero, 2
    addiu $2, $zero, 2
    addiu $11, $sp, 104
    swc1 $f17, 140($sp)
    swc1 $f16, 136($sp)
    swc1 $f15, 132($sp)
    swc1 $f5, 128($sp)
    swc1 $f20, 124($sp)
    swc1 $f6, 120($sp)
    andi $20, $3, 1
    movt $1, $zero, $fcc0
    c.ule.s $f22, $f2
    mtc1 $zero, $f22
    movt $5, $zero, $fcc0
    c.ule.s $f2, $f1
    movf $10, $13, $fcc0
    c.olt.s $f24, $f22
    and $1, $5, $1
    move $5, $10
    addiu $15, $10, -1
    movn $5, $zero, $1
    movn $15, $2, $1
    addiu $6, $5, 1
    xori $9, $5, 2
    sll $1, $15, 2
    movz $6, $zero, $9
    sll $9, $5, 2
    addu $18, $1, $11
    sll $12, $6, 2
    addu $9, $11, $9
    lwc1 $f11, 16($18)
    addu $12, $12, $11
    lwc1 $f3, 16($9)
    lwc1 $f4, 16($12)
    LOAD $f0, $14, 40
    LOAD $f1, $14, 41
    LOAD $f7, $14, 42
    LOAD $f2, $14, 43
    mov.s $f8, $f2
    movt.s $f8, $f0, $fcc0
    movt.s $f0, $f2, $fcc0
    c.olt.s $f25, $f22
    sub.s $f8, $f8, $f15
    sub.s $f0, $f0, $f15
    mul.s $f2, $f28, $f8
    LOAD $f8, $14, 44
    mov.s $f9, $f8
    LOAD $f10, $14, 45
    mul.s $f0, $f24, $f0
    movt.s $f9, $f1, $fcc0
    c.olt.s $f23, $f22
    sub.s $f9, $f9, $f16
    mul.s $f9, $f27, $f9
    FPMIN $f2, $f2, $f9
    mov.s $f9, $f10
    movt.s $f9, $f7, $fcc0
    c.olt.s $f25, $f22
    movt.s $f1, $f8, $fcc0
    c.olt.s $f23, $f22
    movt.s $f7, $f10, $fcc0
    sub.s $f9, $f9, $f17
    sub.s $f1, $f1, $f16
    mul.s $f9, $f26, $f9
    FPMIN $f9, $f9, $f21
    FPMIN $f2, $f2, $f9
    mul.s $f1, $f25, $f1
    FPMAX $f0, $f0, $f1
    sub.s $f1, $f7, $f17
    mul.s $f1, $f23, $f1
    FPMAX $f1, $f1, $f22
    FPMAX $f1, $f0, $f1
    c.ule.s $f1, $f2
    bc1f $BB0_53
    nop
    lwc1 $f0, 80($sp)
    div.s $f29, $f11, $f3
    div.s $f31, $f4, $f3
    sll $1, $6, 1
    sll $3, $15, 1
    sll $10, $5, 1
    addiu $ra, $18, 28
    swc1 $f5, 96($sp)
    swc1 $f6, 100($sp)
    swc1 $f18, 56($sp)
    swc1 $f14, 60($sp)
    swc1 $f13, 64($sp)
    addu $22, $3, $15
    addu $21, $10, $5
    addu $23, $1, $6
    addiu $1, $9, 28
    addiu $3, $12, 28
    addiu $15, $zero, 0
    addiu $12, $zero, -1
    addiu $5, $zero, 0
    move $9, $17
    div.s $f0, $f0, $f3
    sw $1, 68($sp)
    swc1 $f0, 76($sp)
$BB0_19:
    sll $1, $5, 2
    sll $10, $5, 3
    addiu $19, $sp, 200
    negu $6, $5
    addu $1, $10, $1
    addu $18, $19, $1
$BB0_20:
    addu $10, $15, $4
    LOAD $11, $10, 0
    LOAD $f0, $10, 1
    LOAD $f3, $10, 2
    DSTSTEP $10, $15, $11, $f1, $f2, $f3, $f0, $11, $f0, $f3, $f15, $f16, $f17, $f24, $f25, $f23, $f28, $f27, $f26
    beq $10, $13, $BB0_20
    nop
$BB0_21:
    beqz $10, $BB0_41
    nop
$BB0_22:
    addiu $1, $zero, 2
    bne $10, $1, $BB0_24
    nop
$BB0_23:
    sll $1, $5, 2
    sll $10, $5, 3
    addiu $18, $18, 12
    addiu $6, $6, -1
    addiu $5, $5, 1
    addu $1, $10, $1
    addu $1, $19, $1
    sw $11, 0($1)
    swc1 $f3, 4($1)
    j $BB0_20
    swc1 $f0, 8($1)
$BB0_24:
    sll $1, $15, 1
    sll $5, $15, 3
    lw $2, 44($sp)
    addu $1, $5, $1
    addu $19, $1, $2
    lw $1, 68($sp)
    lwc1 $f2, 0($1)
    j $BB0_27
    nop
$BB0_25:
    mov.s $f21, $f4
    move $9, $5
    move $12, $19
    swc1 $f1, 152($sp)
    swc1 $f3, 148($sp)
    swc1 $f1, 88($sp)
    beqz $20, $BB0_51
    swc1 $f3, 84($sp)
$BB0_26:
    and $1, $15, $16
    bnez $1, $BB0_41
    addiu $19, $19, 10
$BB0_27:
    lwc1 $f3, 0($3)
    addu $5, $23, $19
    lwc1 $f0, 0($ra)
    LOAD $f1, $5, 0
    addu $10, $22, $19
    LOAD $f4, $5, 1
    LOAD $f7, $5, 2
    LOAD $f8, $10, 0
    LOAD $f9, $10, 1
    LOAD $f11, $10, 2
    addu $10, $21, $19
    ori $5, $8, 65535
    sub.s $f10, $f1, $f3
    LOAD $f1, $10, 0
    sub.s $f4, $f4, $f3
    sub.s $f7, $f7, $f3
    LOAD $f3, $10, 1
    sub.s $f8, $f8, $f0
    sub.s $f9, $f9, $f0
    sub.s $f0, $f11, $f0
    sub.s $f1, $f1, $f2
    sub.s $f3, $f3, $f2
    mfc1 $14, $f4
    mfc1 $15, $f9
    mfc1 $11, $f10
    mfc1 $fp, $f7
    mul.s $f12, $f29, $f1
    and $11, $11, $5
    sub.s $f30, $f8, $f12
    mul.s $f12, $f31, $f3
    sub.s $f4, $f4, $f12
    mul.s $f12, $f29, $f3
    mfc1 $7, $f30
    and $7, $7, $5
    mtc1 $7, $f14
    and $7, $14, $5
    sub.s $f9, $f9, $f12
    mul.s $f12, $f31, $f1
    mfc1 $1, $f4
    and $1, $1, $5
    mtc1 $1, $f13
    LOAD $f6, $10, 2
    and $10, $fp, $5
    sub.s $f10, $f10, $f12
    mfc1 $2, $f9
    mfc1 $1, $f8
    and $2, $2, $5
    and $1, $1, $5
    mtc1 $2, $f5
    mtc1 $1, $f8
    and $1, $15, $5
    mfc1 $2, $f0
    mfc1 $17, $f10
    mtc1 $1, $f18
    FPMAX $f5, $f14, $f5
    FPMAX $f8, $f8, $f18
    LOAD $15, $19, 9
    mtc1 $11, $f18
    and $17, $17, $5
    mtc1 $17, $f12
    FPMAX $f14, $f12, $f13
    sub.s $f13, $f6, $f2
    mul.s $f6, $f31, $f13
    mul.s $f11, $f29, $f13
    sub.s $f6, $f7, $f6
    sub.s $f0, $f0, $f11
    mul.s $f7, $f30, $f6
    mul.s $f11, $f10, $f0
    mfc1 $1, $f6
    mfc1 $11, $f0
    mul.s $f12, $f4, $f0
    mul.s $f19, $f9, $f6
    mul.s $f0, $f10, $f9
    mul.s $f4, $f30, $f4
    and $11, $11, $5
    and $1, $1, $5
    mtc1 $11, $f6
    sub.s $f11, $f11, $f7
    mtc1 $1, $f7
    and $1, $2, $5
    mfc1 $2, $f1
    sub.s $f12, $f19, $f12
    sub.s $f4, $f4, $f0
    mtc1 $1, $f9
    FPMAX $f14, $f14, $f7
    FPMAX $f5, $f5, $f6
    FPMAX $f6, $f8, $f9
    FPMIN $f10, $f12, $f11
    FPMAX $f7, $f12, $f11
    mtc1 $10, $f8
    mfc1 $1, $f3
    and $2, $2, $5
    mtc1 $7, $f9
    mtc1 $2, $f0
    and $1, $1, $5
    mtc1 $1, $f19
    FPMAX $f0, $f0, $f19
    mfc1 $1, $f13
    and $1, $1, $5
    mtc1 $1, $f19
    FPMAX $f7, $f7, $f4
    FPMAX $f19, $f0, $f19
    FPMAX $f0, $f14, $f5
    FPMAX $f5, $f6, $f19
    FPMAX $f6, $f18, $f9
    FPMIN $f9, $f10, $f4
    FPMAX $f6, $f6, $f8
    FPMAX $f8, $f6, $f5
    mfc1 $2, $f8
    addu $1, $2, $24
    sltu $1, $25, $1
    bnez $1, $BB0_34
    nop
    lwc1 $f10, %gp_rel($CPI0_5)($gp)
    lwc1 $f5, %gp_rel($CPI0_4)($gp)
    mul.s $f6, $f8, $f10
    mul.s $f5, $f8, $f5
    add.s $f0, $f6, $f0
    mul.s $f0, $f5, $f0
    c.ule.s $f7, $f0
    bc1t $BB0_30
    neg.s $f30, $f0
    c.olt.s $f9, $f30
    bc1t $BB0_26
    nop
$BB0_30:
    c.ule.s $f9, $f0
    bc1f $BB0_32
    nop
    c.olt.s $f7, $f30
    bc1f $BB0_34
    nop
$BB0_32:
    neg.s $f6, $f9
    mul.s $f3, $f3, $f11
    mul.s $f1, $f1, $f12
    lwc1 $f5, %gp_rel($CPI0_6)($gp)
    FPMAX $f6, $f7, $f6
    mul.s $f6, $f6, $f10
    mul.s $f5, $f8, $f5
    add.s $f1, $f1, $f3
    mul.s $f3, $f13, $f4
    add.s $f0, $f0, $f6
    mul.s $f5, $f5, $f0
    add.s $f0, $f3, $f1
    mfc1 $1, $f0
    and $1, $1, $5
    mtc1 $1, $f1
    c.ule.s $f1, $f5
    bc1t $BB0_34
    nop
    lwc1 $f1, 76($sp)
    lwc1 $f3, 80($sp)
    mul.s $f0, $f1, $f0
    add.s $f1, $f12, $f11
    add.s $f1, $f4, $f1
    div.s $f3, $f3, $f1
    mul.s $f12, $f3, $f0
    mul.s $f1, $f4, $f3
    j $BB0_35
    mul.s $f3, $f11, $f3
$BB0_34:
    lwc1 $f1, 96($sp)
    lwc1 $f0, 100($sp)
    EXACT $2, $f12, $f3, $f1, $19, $f15, $f16, $f17, $f0, $f20, $f1
    beqz $2, $BB0_26
    nop
$BB0_35:
    LOAD $f0, $19, 0
    LOAD $f4, $19, 1
    FPMAX $f13, $f0, $f4
    LOAD $f5, $19, 2
    LOAD $f6, $19, 3
    LOAD $f7, $19, 4
    LOAD $f8, $19, 5
    c.olt.s $f24, $f22
    LOAD $f9, $19, 6
    LOAD $f10, $19, 7
    LOAD $f11, $19, 8
    FPMIN $f0, $f0, $f4
    FPMAX $f13, $f13, $f5
    mov.s $f4, $f13
    FPMIN $f0, $f0, $f5
    FPMAX $f5, $f6, $f7
    FPMIN $f6, $f6, $f7
    FPMAX $f5, $f5, $f8
    mov.s $f7, $f5
    FPMIN $f6, $f6, $f8
    FPMIN $f8, $f9, $f10
    FPMIN $f8, $f8, $f11
    movt.s $f4, $f0, $fcc0
    movt.s $f0, $f13, $fcc0
    c.olt.s $f25, $f22
    movt.s $f7, $f6, $fcc0
    c.olt.s $f23, $f22
    sub.s $f4, $f4, $f15
    sub.s $f0, $f0, $f15
    sub.s $f7, $f7, $f16
    mul.s $f4, $f28, $f4
    mul.s $f0, $f24, $f0
    mul.s $f7, $f27, $f7
    FPMIN $f4, $f4, $f7
    FPMAX $f7, $f9, $f10
    FPMAX $f7, $f7, $f11
    mov.s $f9, $f7
    movt.s $f9, $f8, $fcc0
    c.olt.s $f25, $f22
    movt.s $f6, $f5, $fcc0
    c.olt.s $f23, $f22
    sub.s $f9, $f9, $f17
    movt.s $f8, $f7, $fcc0
    mul.s $f9, $f26, $f9
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
    bc1f $BB0_26
    nop
    c.olt.s $f4, $f22
    bc1t $BB0_26
    nop
    c.ule.s $f4, $f21
    bc1f $BB0_26
    nop
    lw $1, 92($sp)
    c.ult.s $f4, $f21
    bc1t $BB0_25
    and $5, $15, $1
    slt $1, $5, $9
    beqz $1, $BB0_26
    nop
    j $BB0_25
    nop
$BB0_41:
    addiu $6, $6, 1
    beq $6, $13, $BB0_44
    nop
    lwc1 $f1, -8($18)
    addiu $10, $18, -12
    c.ule.s $f1, $f21
    bc1f $BB0_41
    move $18, $10
    lw $15, 0($10)
    lwc1 $f0, 8($10)
    negu $5, $6
    FPMIN $f2, $f0, $f21
    j $BB0_19
    nop
$BB0_44:
    beqz $20, $BB0_55
    nop
    bltz $12, $BB0_61
    nop
    LOAD $f2, $12, 0
    LOAD $f26, $12, 1
    LOAD $f25, $12, 2
    sub.s $f16, $f26, $f2
    LOAD $f1, $12, 3
    LOAD $f11, $12, 4
    sub.s $f21, $f11, $f1
    LOAD $f28, $12, 5
    ori $3, $8, 65535
    sub.s $f15, $f28, $f1
    sub.s $f23, $f25, $f2
    lui $19, 32640
    lwc1 $f5, %gp_rel($CPI0_7)($gp)
    addiu $14, $zero, 0
    mfc1 $2, $f16
    mfc1 $1, $f21
    and $2, $2, $3
    and $1, $1, $3
    mtc1 $2, $f0
    mtc1 $1, $f3
    LOAD $f17, $12, 6
    LOAD $f27, $12, 7
    LOAD $f12, $12, 8
    mfc1 $2, $f23
    sub.s $f24, $f12, $f17
    lw $17, 48($sp)
    lwc1 $f19, 72($sp)
    FPMAX $f0, $f0, $f3
    sub.s $f3, $f27, $f17
    mfc1 $1, $f15
    and $2, $2, $3
    mtc1 $2, $f4
    and $1, $1, $3
    mtc1 $1, $f6
    mfc1 $1, $f3
    and $1, $1, $3
    mtc1 $1, $f7
    FPMAX $f0, $f0, $f7
    FPMAX $f4, $f4, $f6
    mfc1 $1, $f24
    and $1, $1, $3
    mtc1 $1, $f6
    FPMAX $f4, $f4, $f6
    FPMAX $f0, $f0, $f4
    mfc1 $2, $f0
    and $1, $2, $19
    lui $2, 32512
    subu $2, $2, $1
    mtc1 $2, $f0
    mul.s $f6, $f24, $f0
    mul.s $f7, $f16, $f0
    mul.s $f8, $f23, $f0
    mul.s $f9, $f3, $f0
    mul.s $f13, $f15, $f0
    mul.s $f14, $f21, $f0
    mul.s $f10, $f9, $f8
    mul.s $f4, $f7, $f6
    mul.s $f9, $f9, $f13
    mul.s $f0, $f14, $f6
    mul.s $f8, $f14, $f8
    mul.s $f7, $f7, $f13
    sub.s $f4, $f10, $f4
    sub.s $f0, $f0, $f9
    sub.s $f7, $f7, $f8
    mul.s $f10, $f4, $f4
    mul.s $f6, $f0, $f0
    mul.s $f8, $f7, $f7
    add.s $f6, $f6, $f10
    add.s $f8, $f8, $f6
    c.ult.s $f8, $f5
    bc1f $BB0_48
    nop
    lwc1 $f0, 96($sp)
    neg.s $f14, $f20
    neg.s $f13, $f0
    lwc1 $f0, 100($sp)
    j $BB0_49
    neg.s $f18, $f0
$BB0_48:
    lwc1 $f6, 100($sp)
    mul.s $f5, $f20, $f4
    lui $6, 32768
    mul.s $f6, $f6, $f0
    add.s $f5, $f6, $f5
    lwc1 $f6, 96($sp)
    mul.s $f6, $f6, $f7
    add.s $f5, $f6, $f5
    mfc1 $2, $f5
    FPINVSQRT $f5, $f8
    and $2, $2, $6
    mfc1 $5, $f5
    xor $1, $5, $2
    xor $2, $1, $6
    mtc1 $2, $f5
    mul.s $f13, $f7, $f5
    mul.s $f14, $f4, $f5
    mul.s $f18, $f0, $f5
$BB0_49:
    mfc1 $1, $f1
    mfc1 $9, $f2
    mfc1 $2, $f11
    mfc1 $10, $f26
    lwc1 $f7, %gp_rel($CPI0_8)($gp)
    mfc1 $5, $f17
    lwc1 $f10, 84($sp)
    mfc1 $6, $f12
    mfc1 $7, $f28
    swc1 $f13, 164($sp)
    swc1 $f14, 160($sp)
    swc1 $f18, 156($sp)
    and $1, $1, $3
    and $9, $9, $3
    and $2, $2, $3
    and $10, $10, $3
    mul.s $f19, $f19, $f7
    and $5, $5, $3
    and $6, $6, $3
    and $7, $7, $3
    mul.s $f3, $f3, $f10
    mtc1 $1, $f0
    mfc1 $1, $f27
    mtc1 $9, $f8
    mtc1 $2, $f4
    mfc1 $2, $f25
    mtc1 $10, $f9
    mtc1 $5, $f5
    and $1, $1, $3
    and $2, $2, $3
    mtc1 $1, $f6
    FPMAX $f7, $f8, $f9
    mul.s $f8, $f16, $f10
    FPMAX $f5, $f5, $f6
    FPMAX $f0, $f0, $f4
    mtc1 $6, $f4
    swc1 $f19, 116($sp)
    add.s $f3, $f17, $f3
    mtc1 $7, $f6
    FPMAX $f0, $f0, $f6
    FPMAX $f4, $f5, $f4
    mtc1 $2, $f5
    LOAD $f9, $14, 28
    FPMAX $f0, $f0, $f4
    FPMAX $f4, $f7, $f5
    LOAD $f5, $14, 29
    lwc1 $f11, 88($sp)
    mul.s $f6, $f21, $f10
    FPMAX $f0, $f4, $f0
    add.s $f2, $f2, $f8
    lwc1 $f8, %gp_rel($CPI0_9)($gp)
    mul.s $f7, $f23, $f11
    mul.s $f10, $f15, $f11
    mul.s $f0, $f0, $f8
    add.s $f1, $f1, $f6
    mul.s $f6, $f24, $f11
    LOAD $f11, $14, 30
    add.s $f2, $f2, $f7
    mul.s $f4, $f18, $f0
    mul.s $f7, $f14, $f0
    add.s $f1, $f1, $f10
    mul.s $f0, $f13, $f0
    add.s $f3, $f3, $f6
    add.s $f15, $f4, $f2
    add.s $f16, $f7, $f1
    add.s $f17, $f0, $f3
    sub.s $f2, $f9, $f15
    sub.s $f5, $f5, $f16
    sub.s $f0, $f11, $f17
    mfc1 $1, $f2
    and $1, $1, $3
    mtc1 $1, $f4
    mfc1 $1, $f5
    and $1, $1, $3
    mtc1 $1, $f1
    FPMAX $f1, $f4, $f1
    mfc1 $1, $f0
    and $1, $1, $3
    mtc1 $1, $f3
    FPMAX $f1, $f1, $f3
    mfc1 $2, $f1
    and $5, $2, $19
    lui $1, 32512
    subu $2, $1, $5
    mtc1 $2, $f1
    mul.s $f20, $f5, $f1
    mul.s $f6, $f2, $f1
    mul.s $f5, $f0, $f1
    mul.s $f3, $f14, $f20
    mul.s $f2, $f18, $f6
    mul.s $f0, $f13, $f5
    add.s $f2, $f2, $f3
    add.s $f0, $f0, $f2
    c.ule.s $f0, $f22
    bc1t $BB0_59
    nop
    addiu $3, $zero, 0
    LOAD $f2, $3, 11
    mul.s $f1, $f1, $f2
    mul.s $f3, $f6, $f6
    mtc1 $5, $f21
    mul.s $f2, $f20, $f20
    add.s $f2, $f3, $f2
    mul.s $f3, $f5, $f5
    add.s $f2, $f3, $f2
    lwc1 $f3, %gp_rel($CPI0_10)($gp)
    FPINVSQRT $f2, $f2
    mul.s $f1, $f2, $f1
    mul.s $f3, $f19, $f3
    mul.s $f0, $f3, $f0
    mul.s $f0, $f0, $f2
    mul.s $f0, $f0, $f1
    mul.s $f0, $f1, $f0
    swc1 $f0, 40($sp)
    j $BB0_6
    swc1 $f0, 144($sp)
$BB0_51:
    lw $2, 28($sp)
    lw $17, 48($sp)
    lwc1 $f13, 64($sp)
    lwc1 $f14, 60($sp)
    lwc1 $f18, 56($sp)
    lw $3, 32($sp)
    lwc1 $f19, 72($sp)
    move $12, $19
    addiu $14, $zero, 0
    lui $19, 32640
    swc1 $f1, 88($sp)
    bgez $12, $BB0_57
    swc1 $f3, 84($sp)
    j $BB0_56
    nop
$BB0_53:
    lw $2, 28($sp)
    lw $3, 32($sp)
    lwc1 $f19, 72($sp)
    beqz $20, $BB0_56
    nop
    j $BB0_62
    nop
$BB0_55:
    lw $2, 28($sp)
    lw $17, 48($sp)
    lwc1 $f13, 64($sp)
    lwc1 $f14, 60($sp)
    lwc1 $f18, 56($sp)
    lw $3, 32($sp)
    lwc1 $f19, 72($sp)
    addiu $14, $zero, 0
    bgez $12, $BB0_57
    lui $19, 32640
$BB0_56:
    LOAD $f0, $14, 31
    lwc1 $f1, 40($sp)
    lwc1 $f2, 16($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 16($sp)
    swc1 $f2, 104($sp)
    LOAD $f0, $14, 32
    lwc1 $f2, 20($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 20($sp)
    swc1 $f2, 108($sp)
    LOAD $f0, $14, 33
    mul.s $f0, $f1, $f0
    lwc1 $f1, 24($sp)
    add.s $f1, $f1, $f0
    swc1 $f1, 24($sp)
    swc1 $f1, 112($sp)
$BB0_57:
    beqz $3, $BB0_2
    nop
$BB0_58:
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
    mul.s $f6, $f18, $f14
    mul.s $f5, $f0, $f5
    mul.s $f0, $f0, $f1
    mul.s $f8, $f3, $f13
    mul.s $f9, $f3, $f18
    mul.s $f3, $f3, $f14
    mul.s $f7, $f7, $f4
    mul.s $f6, $f6, $f4
    add.s $f7, $f2, $f7
    mul.s $f10, $f2, $f6
    mul.s $f2, $f18, $f2
    mul.s $f6, $f5, $f6
    mul.s $f7, $f5, $f7
    mul.s $f1, $f0, $f10
    add.s $f1, $f1, $f7
    mul.s $f7, $f18, $f2
    mul.s $f4, $f7, $f4
    add.s $f20, $f3, $f1
    add.s $f4, $f4, $f11
    mul.s $f4, $f0, $f4
    mul.s $f0, $f0, $f2
    add.s $f1, $f6, $f4
    sub.s $f0, $f8, $f0
    add.s $f6, $f9, $f1
    mul.s $f1, $f5, $f14
    j $BB0_5
    sub.s $f5, $f0, $f1
$BB0_59:
    lw $2, 28($sp)
    lw $3, 32($sp)
    bnez $3, $BB0_58
    nop
    j $BB0_2
    nop
$BB0_61:
    lw $2, 28($sp)
    lw $17, 48($sp)
    lwc1 $f13, 64($sp)
    lwc1 $f14, 60($sp)
    lwc1 $f18, 56($sp)
    lwc1 $f19, 72($sp)
    addiu $14, $zero, 0
    lui $19, 32640
$BB0_62:
    LOAD $f0, $14, 34
    lwc1 $f3, 16($sp)
    mul.s $f0, $f19, $f0
    add.s $f3, $f3, $f0
    swc1 $f3, 104($sp)
    LOAD $f0, $14, 35
    lwc1 $f2, 20($sp)
    mul.s $f0, $f19, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 108($sp)
    LOAD $f0, $14, 36
    lwc1 $f1, 24($sp)
    mul.s $f0, $f19, $f0
    add.s $f1, $f1, $f0
    j $BB0_3
    swc1 $f1, 112($sp)
$BB0_63:
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
