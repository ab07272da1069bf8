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
    addiu $sp, $sp, -1832
    sdc1 $f30, 1824($sp)
    sdc1 $f28, 1816($sp)
    sdc1 $f26, 1808($sp)
    sdc1 $f24, 1800($sp)
    sdc1 $f22, 1792($sp)
    sdc1 $f20, 1784($sp)
    sw $ra, 1780($sp)
    sw $fp, 1776($sp)
    sw $23, 1772($sp)
    sw $22, 1768($sp)
    sw $21, 1764($sp)
    sw $20, 1760($sp)
    sw $19, 1756($sp)
    sw $18, 1752($sp)
    sw $17, 1748($sp)
    sw $16, 1744($sp)
    addiu $17, $zero, 0
    LOAD $2, $17, 1
    LOAD $4, $17, 8
    LOAD $3, $17, 9
    sw $3, 56($sp)
    ATOMIC_INC $6, 0
    slt $1, $6, $2
    beqz $1, $BB0_65
    sw $2, 12($sp)
    lwc1 $f0, %gp_rel($CPI0_0)($gp)
    lui $1, 32639
    lui $8, 32767
    lui $18, 32640
    addiu $13, $zero, 1
    lui $24, 53120
    ori $1, $1, 65535
    ori $19, $8, 65535
    swc1 $f0, 84($sp)
    mtc1 $zero, $f0
    sw $1, 40($sp)
    lui $1, 4095
    sw $19, 48($sp)
    ori $15, $1, 65535
    lui $1, 8319
    swc1 $f0, 8($sp)
    lwc1 $f0, %gp_rel($CPI0_1)($gp)
    ori $25, $1, 65535
    lui $1, 1023
    ori $1, $1, 65535
    swc1 $f0, 4($sp)
    lwc1 $f0, %gp_rel($CPI0_2)($gp)
    sw $1, 100($sp)
    swc1 $f0, 16($sp)
    lwc1 $f0, %gp_rel($CPI0_3)($gp)
    swc1 $f0, 52($sp)
    j $BB0_4
    lui $16, 2048
$BB0_2:
    lwc1 $f1, 28($sp)
    lwc1 $f2, 24($sp)
    lwc1 $f3, 20($sp)
$BB0_3:
    sll $1, $2, 1
    swc1 $f14, 60($sp)
    swc1 $f12, 64($sp)
    addu $2, $1, $2
    LOAD $3, $17, 7
    addu $2, $3, $2
    STORE $f3, $2, 0
    STORE $f2, $2, 1
    STORE $f1, $2, 2
    ATOMIC_INC $6, 0
    lw $1, 12($sp)
    slt $1, $6, $1
    beqz $1, $BB0_65
    nop
$BB0_4:
    mtc1 $6, $f0
    LOAD $3, $17, 4
    LOAD $f1, $17, 3
    sw $6, 32($sp)
    cvt.s.w $f0, $f0
    mul.s $f0, $f1, $f0
    trunc.w.s $f0, $f0
    mfc1 $5, $f0
    mul $1, $3, $5
    subu $7, $6, $1
    LOAD $f0, $17, 19
    LOAD $f1, $17, 22
    LOAD $f2, $17, 25
    LOAD $f4, $17, 20
    LOAD $f6, $17, 23
    sra $9, $7, 31
    and $1, $9, $3
    addu $1, $1, $7
    slt $7, $1, $3
    movn $3, $zero, $7
    subu $1, $1, $3
    xori $3, $7, 1
    mtc1 $1, $f7
    LOAD $f8, $17, 26
    lwc1 $f3, 4($sp)
    addu $1, $9, $5
    cvt.s.w $f7, $f7
    addu $1, $1, $3
    mtc1 $1, $f9
    LOAD $f10, $17, 21
    LOAD $f11, $17, 24
    cvt.s.w $f9, $f9
    add.s $f7, $f7, $f3
    add.s $f9, $f9, $f3
    mul.s $f1, $f1, $f7
    mul.s $f6, $f6, $f7
    mul.s $f2, $f2, $f9
    add.s $f0, $f0, $f1
    add.s $f4, $f4, $f6
    LOAD $f1, $17, 27
    LOAD $f15, $17, 16
    LOAD $f16, $17, 17
    LOAD $f17, $17, 18
    mul.s $f1, $f1, $f9
    lui $1, 16256
    sw $1, 124($sp)
    sw $zero, 120($sp)
    sw $zero, 116($sp)
    sw $zero, 112($sp)
    LOAD $2, $17, 2
    sw $2, 36($sp)
    add.s $f0, $f2, $f0
    mul.s $f2, $f8, $f9
    add.s $f2, $f2, $f4
    mul.s $f6, $f0, $f0
    mul.s $f4, $f2, $f2
    add.s $f4, $f6, $f4
    mul.s $f6, $f11, $f7
    add.s $f6, $f10, $f6
    add.s $f1, $f1, $f6
    mul.s $f6, $f1, $f1
    add.s $f4, $f6, $f4
    FPINVSQRT $f4, $f4
    mul.s $f14, $f4, $f0
    lwc1 $f0, 8($sp)
    mul.s $f5, $f4, $f1
    mul.s $f20, $f4, $f2
    swc1 $f0, 28($sp)
    swc1 $f0, 24($sp)
    swc1 $f0, 20($sp)
    lwc1 $f0, 84($sp)
    swc1 $f0, 72($sp)
$BB0_5:
    lwc1 $f21, 16($sp)
    addiu $1, $zero, 1
    sw $1, 96($sp)
$BB0_6:
    mfc1 $1, $f14
    and $1, $1, $19
    mtc1 $1, $f22
    mfc1 $1, $f20
    and $1, $1, $19
    mtc1 $1, $f2
    LOAD $3, $17, 10
    lwc1 $f1, 84($sp)
    FPMIN $f0, $f22, $f2
    lwc1 $f3, 52($sp)
    div.s $f23, $f1, $f5
    div.s $f6, $f1, $f20
    div.s $f1, $f1, $f14
    mfc1 $9, $f6
    mfc1 $10, $f1
    mfc1 $7, $f23
    addu $5, $10, $3
    addu $11, $9, $3
    addu $12, $7, $3
    mfc1 $1, $f5
    and $1, $1, $19
    mtc1 $1, $f29
    FPMIN $f0, $f0, $f29
    c.olt.s $f0, $f3
    mtc1 $12, $f26
    mtc1 $11, $f27
    mtc1 $5, $f28
    bc1f $BB0_12
    nop
    beqz $3, $BB0_13
    nop
    mtc1 $zero, $f4
    c.eq.s $f14, $f4
    bc1f $BB0_14
    mov.s $f24, $f1
    c.eq.s $f20, $f4
    bc1f $BB0_15
    mov.s $f25, $f6
$BB0_10:
    c.eq.s $f5, $f4
    bc1f $BB0_16
    nop
$BB0_11:
    mov.s $f26, $f23
    mov.s $f27, $f6
    j $BB0_17
    mov.s $f28, $f1
$BB0_12:
    mov.s $f25, $f6
    j $BB0_17
    mov.s $f24, $f1
$BB0_13:
    mov.s $f25, $f6
    j $BB0_17
    mov.s $f24, $f1
$BB0_14:
    ori $1, $8, 65535
    lui $11, 32640
    and $1, $10, $1
    lw $10, 40($sp)
    sltu $5, $1, $10
    movn $10, $1, $5
    addu $1, $10, $3
    slt $5, $1, $18
    movn $11, $1, $5
    mfc1 $5, $f14
    lui $1, 32768
    and $5, $5, $1
    or $11, $5, $11
    or $5, $5, $10
    mtc1 $11, $f1
    mtc1 $5, $f24
    c.eq.s $f20, $f4
    bc1t $BB0_10
    mov.s $f25, $f6
$BB0_15:
    ori $1, $8, 65535
    lui $10, 32640
    and $1, $9, $1
    lw $9, 40($sp)
    sltu $5, $1, $9
    movn $9, $1, $5
    addu $1, $9, $3
    slt $5, $1, $18
    movn $10, $1, $5
    mfc1 $5, $f20
    lui $1, 32768
    and $5, $5, $1
    or $10, $5, $10
    or $5, $5, $9
    mtc1 $10, $f6
    mtc1 $5, $f25
    c.eq.s $f5, $f4
    bc1t $BB0_11
    nop
$BB0_16:
    ori $1, $8, 65535
    mov.s $f27, $f6
    mov.s $f28, $f1
    and $1, $7, $1
    lw $7, 40($sp)
    sltu $5, $1, $7
    movn $7, $1, $5
    lui $5, 32640
    addu $1, $7, $3
    slt $3, $1, $18
    movn $5, $1, $3
    mfc1 $3, $f5
    lui $1, 32768
    and $3, $3, $1
    or $5, $3, $5
    or $3, $3, $7
    mtc1 $5, $f26
    mtc1 $3, $f23
$BB0_17:
    c.ule.s $f22, $f29
    addiu $1, $zero, 1
    addiu $3, $zero, 1
    addiu $5, $zero, 2
    addiu $10, $sp, 112
    addiu $2, $zero, 2
    swc1 $f17, 148($sp)
    swc1 $f16, 144($sp)
    swc1 $f15, 140($sp)
    swc1 $f5, 136($sp)
    swc1 $f20, 132($sp)
    swc1 $f14, 128($sp)
    movt $1, $zero, $fcc0
    c.ule.s $f22, $f2
    mtc1 $zero, $f22
    movt $3, $zero, $fcc0
    c.ule.s $f2, $f29
    movf $5, $13, $fcc0
    c.olt.s $f24, $f22
    and $1, $3, $1
    move $3, $5
    movn $3, $zero, $1
    addiu $7, $3, 1
    xori $9, $3, 2
    movz $7, $zero, $9
    sll $9, $3, 2
    sll $11, $7, 2
    addu $9, $10, $9
    addu $12, $11, $10
    addiu $11, $5, -1
    lwc1 $f1, 16($9)
    movn $11, $2, $1
    lwc1 $f2, 16($12)
    sll $1, $11, 2
    addu $14, $1, $10
    lwc1 $f4, 16($14)
    LOAD $f0, $17, 40
    LOAD $f6, $17, 41
    LOAD $f7, $17, 42
    LOAD $f8, $17, 43
    mov.s $f9, $f8
    mov.s $f11, $f6
    LOAD $f10, $17, 44
    movt.s $f9, $f0, $fcc0
    c.olt.s $f25, $f22
    movt.s $f11, $f10, $fcc0
    c.olt.s $f24, $f22
    movt.s $f0, $f8, $fcc0
    c.olt.s $f25, $f22
    sub.s $f9, $f9, $f15
    movt.s $f10, $f6, $fcc0
    c.olt.s $f23, $f22
    sub.s $f11, $f11, $f16
    mul.s $f9, $f28, $f9
    sub.s $f0, $f0, $f15
    sub.s $f6, $f10, $f16
    LOAD $f10, $17, 45
    mul.s $f8, $f25, $f11
    mul.s $f0, $f24, $f0
    FPMAX $f0, $f0, $f8
    mul.s $f6, $f27, $f6
    FPMIN $f6, $f9, $f6
    mov.s $f9, $f10
    movt.s $f9, $f7, $fcc0
    c.olt.s $f23, $f22
    movt.s $f7, $f10, $fcc0
    sub.s $f9, $f9, $f17
    sub.s $f7, $f7, $f17
    mul.s $f9, $f26, $f9
    FPMIN $f9, $f9, $f21
    FPMIN $f6, $f6, $f9
    mul.s $f7, $f23, $f7
    FPMAX $f7, $f7, $f22
    FPMAX $f0, $f0, $f7
    c.ule.s $f0, $f6
    bc1f $BB0_56
    nop
    lwc1 $f0, 84($sp)
    div.s $f29, $f4, $f1
    div.s $f31, $f2, $f1
    sll $1, $7, 1
    sll $5, $11, 1
    sll $10, $3, 1
    swc1 $f5, 104($sp)
    swc1 $f14, 108($sp)
    swc1 $f13, 68($sp)
    addu $fp, $1, $7
    addiu $1, $9, 28
    addu $22, $10, $3
    addu $23, $5, $11
    addiu $7, $12, 28
    addiu $11, $zero, 0
    addiu $3, $14, 28
    addiu $12, $zero, -1
    move $9, $19
    div.s $f0, $f0, $f1
    sw $1, 76($sp)
    swc1 $f0, 80($sp)
    LOAD $18, $11, 46
$BB0_19:
    sll $1, $11, 3
    addiu $21, $sp, 208
    negu $14, $11
    j $BB0_21
    addu $19, $21, $1
$BB0_20:
    bnez $5, $BB0_25
    nop
$BB0_21:
    bltz $18, $BB0_26
    and $5, $18, $15
    addu $5, $5, $4
    LOAD $18, $5, 0
    LOAD $f0, $5, 1
    LOAD $f1, $5, 2
    LOAD $f2, $5, 3
    LOAD $f4, $5, 4
    LOAD $f6, $5, 5
    LOAD $f7, $5, 6
    LOAD $10, $5, 7
    LOAD $f8, $5, 8
    LOAD $f9, $5, 9
    LOAD $f10, $5, 10
    LOAD $f11, $5, 11
    LOAD $f12, $5, 12
    LOAD $f13, $5, 13
    BOXTEST2 $6, $f0, $f1, $f0, $f1, $f2, $f4, $f6, $f7, $f8, $f9, $f10, $f11, $f12, $f13, $f15, $f16, $f17, $f24, $f25, $f23, $f28, $f27, $f26, $f21
    andi $1, $6, 1
    bnez $1, $BB0_20
    andi $5, $6, 2
    bnez $5, $BB0_21
    move $18, $10
    j $BB0_43
    nop
$BB0_25:
    mov.s $f2, $f1
    c.olt.s $f1, $f0
    move $1, $10
    sll $5, $11, 3
    addiu $19, $19, 8
    addiu $14, $14, -1
    addiu $11, $11, 1
    addu $5, $21, $5
    movt $1, $18, $fcc0
    movt.s $f2, $f0, $fcc0
    c.olt.s $f1, $f0
    movt $18, $10, $fcc0
    swc1 $f2, 4($5)
    j $BB0_21
    sw $1, 0($5)
$BB0_26:
    sll $1, $5, 1
    sll $5, $5, 3
    lw $2, 56($sp)
    addu $1, $5, $1
    addu $21, $1, $2
    lw $1, 76($sp)
    lwc1 $f2, 0($1)
    j $BB0_29
    nop
$BB0_27:
    mov.s $f21, $f4
    lw $1, 96($sp)
    move $9, $10
    move $12, $21
    swc1 $f1, 160($sp)
    swc1 $f6, 156($sp)
    swc1 $f1, 92($sp)
    andi $1, $1, 1
    beqz $1, $BB0_53
    swc1 $f6, 88($sp)
$BB0_28:
    and $1, $18, $16
    bnez $1, $BB0_43
    addiu $21, $21, 10
$BB0_29:
    addu $5, $fp, $21
    lwc1 $f4, 0($7)
    lwc1 $f0, 0($3)
    LOAD $f1, $5, 0
    LOAD $f6, $5, 1
    LOAD $f7, $5, 2
    ori $11, $8, 65535
    addu $5, $23, $21
    LOAD $f8, $5, 0
    LOAD $f9, $5, 1
    LOAD $f12, $5, 2
    sub.s $f10, $f1, $f4
    addu $5, $22, $21
    LOAD $f1, $5, 0
    sub.s $f11, $f6, $f4
    sub.s $f8, $f8, $f0
    sub.s $f4, $f7, $f4
    sub.s $f9, $f9, $f0
    sub.s $f0, $f12, $f0
    sub.s $f1, $f1, $f2
    mfc1 $2, $f11
    mfc1 $10, $f9
    mfc1 $6, $f10
    mfc1 $ra, $f4
    mul.s $f6, $f29, $f1
    and $6, $6, $11
    and $2, $2, $11
    sub.s $f14, $f8, $f6
    LOAD $f6, $5, 1
    sub.s $f6, $f6, $f2
    mfc1 $18, $f14
    mul.s $f7, $f31, $f6
    and $18, $18, $11
    mtc1 $18, $f30
    sub.s $f7, $f11, $f7
    mul.s $f11, $f29, $f6
    sub.s $f9, $f9, $f11
    mul.s $f11, $f31, $f1
    mfc1 $1, $f7
    and $1, $1, $11
    mtc1 $1, $f13
    LOAD $f3, $5, 2
    mfc1 $5, $f0
    sub.s $f10, $f10, $f11
    mfc1 $17, $f9
    mfc1 $1, $f8
    and $17, $17, $11
    and $1, $1, $11
    mtc1 $1, $f8
    and $1, $10, $11
    mtc1 $17, $f5
    and $10, $ra, $11
    mfc1 $20, $f10
    mtc1 $1, $f18
    FPMAX $f5, $f30, $f5
    FPMAX $f8, $f8, $f18
    LOAD $18, $21, 9
    mtc1 $6, $f18
    and $20, $20, $11
    mtc1 $20, $f11
    FPMAX $f30, $f11, $f13
    sub.s $f13, $f3, $f2
    mul.s $f3, $f31, $f13
    mul.s $f11, $f29, $f13
    sub.s $f3, $f4, $f3
    sub.s $f0, $f0, $f11
    mfc1 $1, $f3
    mul.s $f4, $f14, $f3
    mul.s $f11, $f10, $f0
    mul.s $f19, $f9, $f3
    mul.s $f12, $f7, $f0
    mfc1 $6, $f0
    mul.s $f0, $f10, $f9
    mul.s $f3, $f14, $f7
    and $1, $1, $11
    and $6, $6, $11
    mtc1 $1, $f7
    and $1, $5, $11
    mfc1 $5, $f1
    mtc1 $1, $f9
    sub.s $f12, $f19, $f12
    sub.s $f11, $f11, $f4
    mtc1 $6, $f4
    FPMAX $f14, $f30, $f7
    FPMAX $f5, $f5, $f4
    FPMAX $f8, $f8, $f9
    FPMIN $f10, $f12, $f11
    FPMAX $f7, $f12, $f11
    mtc1 $2, $f19
    mfc1 $1, $f6
    and $5, $5, $11
    sub.s $f4, $f3, $f0
    mtc1 $10, $f9
    mtc1 $5, $f0
    and $1, $1, $11
    mtc1 $1, $f3
    FPMAX $f0, $f0, $f3
    mfc1 $1, $f13
    and $1, $1, $11
    mtc1 $1, $f3
    FPMAX $f7, $f7, $f4
    FPMAX $f3, $f0, $f3
    FPMAX $f0, $f14, $f5
    FPMAX $f5, $f18, $f19
    FPMAX $f5, $f5, $f9
    FPMAX $f3, $f8, $f3
    FPMAX $f8, $f5, $f3
    FPMIN $f9, $f10, $f4
    mfc1 $2, $f8
    addu $1, $2, $24
    sltu $1, $25, $1
    bnez $1, $BB0_36
    nop
    lwc1 $f10, %gp_rel($CPI0_5)($gp)
    lwc1 $f3, %gp_rel($CPI0_4)($gp)
    mul.s $f5, $f8, $f10
    mul.s $f3, $f8, $f3
    add.s $f0, $f5, $f0
    mul.s $f0, $f3, $f0
    c.ule.s $f7, $f0
    bc1t $BB0_32
    neg.s $f14, $f0
    c.olt.s $f9, $f14
    bc1t $BB0_28
    nop
$BB0_32:
    c.ule.s $f9, $f0
    bc1f $BB0_34
    nop
    c.olt.s $f7, $f14
    bc1f $BB0_36
    nop
$BB0_34:
    mul.s $f3, $f6, $f11
    neg.s $f6, $f9
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
    and $1, $1, $11
    mtc1 $1, $f1
    c.ule.s $f1, $f5
    bc1t $BB0_36
    nop
    lwc1 $f1, 80($sp)
    lwc1 $f3, 84($sp)
    mul.s $f0, $f1, $f0
    add.s $f1, $f12, $f11
    add.s $f1, $f4, $f1
    div.s $f3, $f3, $f1
    mul.s $f12, $f3, $f0
    mul.s $f1, $f4, $f3
    j $BB0_37
    mul.s $f6, $f11, $f3
$BB0_36:
    lwc1 $f1, 104($sp)
    lwc1 $f0, 108($sp)
    EXACT $2, $f12, $f6, $f1, $21, $f15, $f16, $f17, $f0, $f20, $f1
    beqz $2, $BB0_28
    nop
$BB0_37:
    LOAD $f0, $21, 0
    LOAD $f3, $21, 1
    FPMAX $f13, $f0, $f3
    LOAD $f4, $21, 2
    LOAD $f5, $21, 3
    LOAD $f7, $21, 4
    LOAD $f8, $21, 5
    c.olt.s $f24, $f22
    LOAD $f9, $21, 6
    LOAD $f10, $21, 7
    LOAD $f11, $21, 8
    FPMIN $f0, $f0, $f3
    FPMAX $f13, $f13, $f4
    mov.s $f3, $f13
    FPMIN $f0, $f0, $f4
    FPMAX $f4, $f5, $f7
    FPMIN $f5, $f5, $f7
    FPMAX $f4, $f4, $f8
    mov.s $f7, $f4
    FPMIN $f5, $f5, $f8
    FPMIN $f8, $f9, $f10
    FPMIN $f8, $f8, $f11
    movt.s $f3, $f0, $fcc0
    movt.s $f0, $f13, $fcc0
    c.olt.s $f25, $f22
    movt.s $f7, $f5, $fcc0
    c.olt.s $f23, $f22
    sub.s $f3, $f3, $f15
    sub.s $f0, $f0, $f15
    sub.s $f7, $f7, $f16
    mul.s $f3, $f28, $f3
    mul.s $f0, $f24, $f0
    mul.s $f7, $f27, $f7
    FPMIN $f3, $f3, $f7
    FPMAX $f7, $f9, $f10
    FPMAX $f7, $f7, $f11
    mov.s $f9, $f7
    movt.s $f9, $f8, $fcc0
    c.olt.s $f25, $f22
    movt.s $f5, $f4, $fcc0
    c.olt.s $f23, $f22
    movt.s $f8, $f7, $fcc0
    sub.s $f9, $f9, $f17
    sub.s $f4, $f5, $f16
    mul.s $f9, $f26, $f9
    FPMIN $f3, $f3, $f9
    mul.s $f4, $f25, $f4
    FPMAX $f0, $f0, $f4
    sub.s $f4, $f8, $f17
    mul.s $f4, $f23, $f4
    FPMAX $f0, $f0, $f4
    c.ule.s $f0, $f3
    FPMAX $f4, $f12, $f0
    FPMIN $f4, $f4, $f3
    bc1f $BB0_28
    nop
    c.olt.s $f4, $f22
    bc1t $BB0_28
    nop
    c.ule.s $f4, $f21
    bc1f $BB0_28
    nop
    lw $1, 100($sp)
    c.ult.s $f4, $f21
    bc1t $BB0_27
    and $10, $18, $1
    slt $1, $10, $9
    beqz $1, $BB0_28
    nop
    j $BB0_27
    nop
$BB0_43:
    addiu $14, $14, 1
    beq $14, $13, $BB0_46
    nop
    lwc1 $f0, -4($19)
    addiu $5, $19, -8
    c.ule.s $f0, $f21
    bc1f $BB0_43
    move $19, $5
    lw $18, 0($5)
    j $BB0_19
    negu $11, $14
$BB0_46:
    lw $1, 96($sp)
    andi $1, $1, 1
    beqz $1, $BB0_58
    addiu $17, $zero, 0
    lw $19, 48($sp)
    lwc1 $f13, 68($sp)
    bltz $12, $BB0_63
    lui $18, 32640
    LOAD $f2, $12, 0
    LOAD $f26, $12, 1
    sub.s $f17, $f26, $f2
    LOAD $f25, $12, 2
    LOAD $f15, $12, 3
    LOAD $f11, $12, 4
    sub.s $f1, $f11, $f15
    LOAD $f28, $12, 5
    ori $3, $8, 65535
    sub.s $f16, $f28, $f15
    sub.s $f23, $f25, $f2
    lwc1 $f3, %gp_rel($CPI0_7)($gp)
    mfc1 $2, $f17
    mfc1 $1, $f1
    and $2, $2, $3
    and $1, $1, $3
    mtc1 $2, $f0
    mtc1 $1, $f4
    LOAD $f21, $12, 6
    LOAD $f27, $12, 7
    LOAD $f12, $12, 8
    sub.s $f6, $f27, $f21
    mfc1 $2, $f23
    sub.s $f24, $f12, $f21
    FPMAX $f0, $f0, $f4
    mfc1 $1, $f16
    and $2, $2, $3
    mtc1 $2, $f4
    and $1, $1, $3
    mtc1 $1, $f5
    mfc1 $1, $f6
    and $1, $1, $3
    mtc1 $1, $f7
    FPMAX $f0, $f0, $f7
    FPMAX $f4, $f4, $f5
    mfc1 $1, $f24
    and $1, $1, $3
    mtc1 $1, $f5
    FPMAX $f4, $f4, $f5
    FPMAX $f0, $f0, $f4
    mfc1 $2, $f0
    and $1, $2, $18
    lui $2, 32512
    subu $2, $2, $1
    mtc1 $2, $f0
    mul.s $f5, $f24, $f0
    mul.s $f7, $f17, $f0
    mul.s $f8, $f23, $f0
    mul.s $f9, $f6, $f0
    mul.s $f13, $f16, $f0
    mul.s $f14, $f1, $f0
    mul.s $f10, $f9, $f8
    mul.s $f4, $f7, $f5
    mul.s $f9, $f9, $f13
    mul.s $f0, $f14, $f5
    mul.s $f8, $f14, $f8
    mul.s $f7, $f7, $f13
    sub.s $f4, $f10, $f4
    sub.s $f0, $f0, $f9
    sub.s $f7, $f7, $f8
    mul.s $f10, $f4, $f4
    mul.s $f5, $f0, $f0
    mul.s $f8, $f7, $f7
    add.s $f5, $f5, $f10
    add.s $f8, $f8, $f5
    c.ult.s $f8, $f3
    bc1f $BB0_50
    nop
    lwc1 $f0, 104($sp)
    neg.s $f14, $f20
    neg.s $f13, $f0
    lwc1 $f0, 108($sp)
    j $BB0_51
    neg.s $f18, $f0
$BB0_50:
    lwc1 $f5, 108($sp)
    mul.s $f3, $f20, $f4
    lui $6, 32768
    mul.s $f5, $f5, $f0
    add.s $f3, $f5, $f3
    lwc1 $f5, 104($sp)
    mul.s $f5, $f5, $f7
    add.s $f3, $f5, $f3
    mfc1 $2, $f3
    FPINVSQRT $f3, $f8
    and $2, $2, $6
    mfc1 $5, $f3
    xor $1, $5, $2
    xor $2, $1, $6
    mtc1 $2, $f3
    mul.s $f13, $f7, $f3
    mul.s $f14, $f4, $f3
    mul.s $f18, $f0, $f3
$BB0_51:
    mfc1 $1, $f15
    mfc1 $10, $f26
    mfc1 $5, $f21
    mfc1 $9, $f2
    mfc1 $2, $f11
    mfc1 $7, $f28
    lwc1 $f7, %gp_rel($CPI0_8)($gp)
    lwc1 $f19, 72($sp)
    mfc1 $6, $f12
    swc1 $f13, 172($sp)
    swc1 $f14, 168($sp)
    swc1 $f18, 164($sp)
    and $1, $1, $3
    and $10, $10, $3
    and $5, $5, $3
    and $9, $9, $3
    and $2, $2, $3
    mul.s $f19, $f19, $f7
    and $7, $7, $3
    and $6, $6, $3
    mtc1 $1, $f0
    mfc1 $1, $f27
    mtc1 $10, $f9
    mtc1 $5, $f4
    mtc1 $9, $f8
    mtc1 $2, $f3
    mfc1 $2, $f25
    and $1, $1, $3
    and $2, $2, $3
    mtc1 $1, $f5
    FPMAX $f7, $f8, $f9
    lwc1 $f9, 88($sp)
    FPMAX $f4, $f4, $f5
    FPMAX $f0, $f0, $f3
    mtc1 $6, $f3
    swc1 $f19, 124($sp)
    mtc1 $7, $f5
    FPMAX $f0, $f0, $f5
    FPMAX $f3, $f4, $f3
    mtc1 $2, $f4
    LOAD $f8, $17, 28
    mul.s $f5, $f17, $f9
    FPMAX $f0, $f0, $f3
    FPMAX $f3, $f7, $f4
    mul.s $f4, $f6, $f9
    LOAD $f6, $17, 29
    lwc1 $f10, 92($sp)
    mul.s $f1, $f1, $f9
    LOAD $f11, $17, 30
    swc1 $f14, 64($sp)
    swc1 $f18, 60($sp)
    FPMAX $f0, $f3, $f0
    mul.s $f7, $f23, $f10
    mul.s $f9, $f16, $f10
    mul.s $f10, $f24, $f10
    add.s $f2, $f2, $f5
    lwc1 $f5, %gp_rel($CPI0_9)($gp)
    add.s $f1, $f15, $f1
    add.s $f4, $f21, $f4
    mul.s $f0, $f0, $f5
    add.s $f2, $f2, $f7
    add.s $f1, $f1, $f9
    mul.s $f3, $f18, $f0
    mul.s $f5, $f14, $f0
    mul.s $f0, $f13, $f0
    add.s $f15, $f3, $f2
    add.s $f16, $f5, $f1
    sub.s $f2, $f8, $f15
    sub.s $f5, $f6, $f16
    mfc1 $1, $f2
    and $1, $1, $3
    mtc1 $1, $f3
    mfc1 $1, $f5
    and $1, $1, $3
    mtc1 $1, $f1
    FPMAX $f1, $f3, $f1
    add.s $f3, $f4, $f10
    add.s $f17, $f0, $f3
    sub.s $f0, $f11, $f17
    mfc1 $1, $f0
    and $1, $1, $3
    mtc1 $1, $f3
    FPMAX $f1, $f1, $f3
    mfc1 $2, $f1
    and $3, $2, $18
    lui $1, 32512
    subu $2, $1, $3
    mtc1 $2, $f1
    mul.s $f20, $f5, $f1
    mul.s $f5, $f0, $f1
    mul.s $f3, $f14, $f20
    mul.s $f14, $f2, $f1
    mul.s $f0, $f13, $f5
    mul.s $f2, $f18, $f14
    add.s $f2, $f2, $f3
    add.s $f0, $f0, $f2
    c.ule.s $f0, $f22
    bc1t $BB0_61
    nop
    addiu $1, $zero, 0
    addiu $2, $zero, 0
    mul.s $f3, $f14, $f14
    sw $1, 96($sp)
    mtc1 $3, $f21
    LOAD $f2, $2, 11
    mul.s $f1, $f1, $f2
    swc1 $f19, 72($sp)
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
    swc1 $f0, 44($sp)
    j $BB0_6
    swc1 $f0, 152($sp)
$BB0_53:
    lw $19, 48($sp)
    lwc1 $f13, 68($sp)
    lw $3, 36($sp)
    lwc1 $f19, 72($sp)
    swc1 $f1, 92($sp)
    swc1 $f6, 88($sp)
    move $12, $21
    addiu $17, $zero, 0
    lwc1 $f12, 64($sp)
    lwc1 $f14, 60($sp)
    bltz $12, $BB0_59
    lui $18, 32640
$BB0_54:
    lw $2, 32($sp)
    bnez $3, $BB0_62
    nop
    j $BB0_2
    nop
$BB0_56:
    lw $1, 96($sp)
    lwc1 $f12, 64($sp)
    lwc1 $f14, 60($sp)
    lw $3, 36($sp)
    lwc1 $f19, 72($sp)
    andi $1, $1, 1
    beqz $1, $BB0_59
    nop
    j $BB0_64
    nop
$BB0_58:
    lw $19, 48($sp)
    lwc1 $f13, 68($sp)
    lw $3, 36($sp)
    lwc1 $f19, 72($sp)
    lwc1 $f12, 64($sp)
    lwc1 $f14, 60($sp)
    bgez $12, $BB0_54
    lui $18, 32640
$BB0_59:
    LOAD $f0, $17, 31
    lwc1 $f1, 44($sp)
    lwc1 $f2, 20($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 20($sp)
    swc1 $f2, 112($sp)
    LOAD $f0, $17, 32
    lwc1 $f2, 24($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 24($sp)
    swc1 $f2, 116($sp)
    LOAD $f0, $17, 33
    lw $2, 32($sp)
    mul.s $f0, $f1, $f0
    lwc1 $f1, 28($sp)
    add.s $f1, $f1, $f0
    swc1 $f1, 28($sp)
    bnez $3, $BB0_62
    swc1 $f1, 120($sp)
    j $BB0_2
    nop
$BB0_61:
    lw $2, 32($sp)
    lwc1 $f12, 64($sp)
    lwc1 $f14, 60($sp)
    lw $3, 36($sp)
    beqz $3, $BB0_2
    nop
$BB0_62:
    swc1 $f19, 72($sp)
    RAND $f0
    RAND $f1
    mfc1 $2, $f13
    lwc1 $f2, %gp_rel($CPI0_11)($gp)
    lwc1 $f6, %gp_rel($CPI0_12)($gp)
    lwc1 $f11, 84($sp)
    mul.s $f7, $f12, $f12
    swc1 $f14, 60($sp)
    addiu $3, $3, -1
    swc1 $f12, 64($sp)
    lui $1, 32768
    sw $3, 36($sp)
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
    mul.s $f6, $f14, $f12
    mul.s $f5, $f0, $f5
    mul.s $f0, $f0, $f1
    mul.s $f8, $f3, $f13
    mul.s $f9, $f3, $f14
    mul.s $f3, $f3, $f12
    mul.s $f7, $f7, $f4
    mul.s $f6, $f6, $f4
    add.s $f7, $f2, $f7
    mul.s $f10, $f2, $f6
    mul.s $f2, $f14, $f2
    mul.s $f6, $f5, $f6
    mul.s $f7, $f5, $f7
    mul.s $f1, $f0, $f10
    add.s $f1, $f1, $f7
    mul.s $f7, $f14, $f2
    mul.s $f4, $f7, $f4
    add.s $f20, $f3, $f1
    add.s $f4, $f4, $f11
    mul.s $f4, $f0, $f4
    mul.s $f0, $f0, $f2
    add.s $f1, $f6, $f4
    sub.s $f0, $f8, $f0
    add.s $f14, $f9, $f1
    mul.s $f1, $f5, $f12
    j $BB0_5
    sub.s $f5, $f0, $f1
$BB0_63:
    lwc1 $f12, 64($sp)
    lwc1 $f14, 60($sp)
    lwc1 $f19, 72($sp)
$BB0_64:
    LOAD $f0, $17, 34
    lwc1 $f3, 20($sp)
    mul.s $f0, $f19, $f0
    add.s $f3, $f3, $f0
    swc1 $f3, 112($sp)
    LOAD $f0, $17, 35
    lwc1 $f2, 24($sp)
    mul.s $f0, $f19, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 116($sp)
    LOAD $f0, $17, 36
    lwc1 $f1, 28($sp)
    lw $2, 32($sp)
    mul.s $f0, $f19, $f0
    add.s $f1, $f1, $f0
    j $BB0_3
    swc1 $f1, 120($sp)
$BB0_65:
    lw $16, 1744($sp)
    lw $17, 1748($sp)
    lw $18, 1752($sp)
    lw $19, 1756($sp)
    lw $20, 1760($sp)
    lw $21, 1764($sp)
    lw $22, 1768($sp)
    lw $23, 1772($sp)
    lw $fp, 1776($sp)
    lw $ra, 1780($sp)
    ldc1 $f20, 1784($sp)
    ldc1 $f22, 1792($sp)
    ldc1 $f24, 1800($sp)
    ldc1 $f26, 1808($sp)
    ldc1 $f28, 1816($sp)
    ldc1 $f30, 1824($sp)
    addiu $2, $zero, 0
    jr $ra
    addiu $sp, $sp, 1832
