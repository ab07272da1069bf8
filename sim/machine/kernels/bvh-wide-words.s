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
    addiu $2, $zero, 0
    LOAD $3, $2, 1
    LOAD $4, $2, 8
    sw $4, 60($sp)
    LOAD $4, $2, 9
    sw $4, 48($sp)
    ATOMIC_INC $5, 0
    slt $1, $5, $3
    beqz $1, $BB0_71
    sw $3, 8($sp)
    lwc1 $f0, %gp_rel($CPI0_0)($gp)
    lui $1, 32639
    lui $8, 32767
    lui $17, 32640
    addiu $13, $zero, 1
    lui $24, 53120
    ori $1, $1, 65535
    ori $15, $8, 65535
    swc1 $f0, 96($sp)
    mtc1 $zero, $f0
    sw $1, 36($sp)
    lui $1, 4095
    sw $15, 44($sp)
    ori $ra, $1, 65535
    lui $1, 8319
    swc1 $f0, 4($sp)
    lwc1 $f0, %gp_rel($CPI0_1)($gp)
    ori $25, $1, 65535
    lui $1, 1023
    sw $ra, 40($sp)
    ori $1, $1, 65535
    swc1 $f0, 0($sp)
    lwc1 $f0, %gp_rel($CPI0_2)($gp)
    sw $1, 100($sp)
    swc1 $f0, 12($sp)
    lwc1 $f0, %gp_rel($CPI0_3)($gp)
    swc1 $f0, 56($sp)
    j $BB0_4
    lui $16, 2048
$BB0_2:
    lwc1 $f1, 24($sp)
    lwc1 $f2, 20($sp)
    lwc1 $f3, 16($sp)
$BB0_3:
    sll $1, $3, 1
    swc1 $f14, 64($sp)
    swc1 $f12, 68($sp)
    addu $3, $1, $3
    LOAD $4, $2, 7
    addu $3, $4, $3
    STORE $f3, $3, 0
    STORE $f2, $3, 1
    STORE $f1, $3, 2
    ATOMIC_INC $5, 0
    lw $1, 8($sp)
    slt $1, $5, $1
    beqz $1, $BB0_71
    nop
$BB0_4:
    mtc1 $5, $f0
    LOAD $3, $2, 4
    LOAD $f1, $2, 3
    sw $5, 28($sp)
    cvt.s.w $f0, $f0
    mul.s $f0, $f1, $f0
    trunc.w.s $f0, $f0
    mfc1 $4, $f0
    mul $1, $3, $4
    subu $5, $5, $1
    LOAD $f0, $2, 19
    LOAD $f1, $2, 22
    LOAD $f2, $2, 25
    LOAD $f3, $2, 20
    LOAD $f4, $2, 23
    sra $7, $5, 31
    and $1, $7, $3
    addu $1, $1, $5
    slt $5, $1, $3
    movn $3, $zero, $5
    subu $1, $1, $3
    xori $3, $5, 1
    mtc1 $1, $f7
    LOAD $f8, $2, 26
    lwc1 $f5, 0($sp)
    addu $1, $7, $4
    cvt.s.w $f7, $f7
    addu $1, $1, $3
    mtc1 $1, $f9
    LOAD $f10, $2, 21
    LOAD $f11, $2, 24
    cvt.s.w $f9, $f9
    add.s $f7, $f7, $f5
    add.s $f9, $f9, $f5
    mul.s $f1, $f1, $f7
    mul.s $f4, $f4, $f7
    mul.s $f2, $f2, $f9
    add.s $f0, $f0, $f1
    add.s $f3, $f3, $f4
    LOAD $f1, $2, 27
    LOAD $f15, $2, 16
    LOAD $f16, $2, 17
    LOAD $f17, $2, 18
    mul.s $f1, $f1, $f9
    lui $1, 16256
    sw $1, 124($sp)
    sw $zero, 120($sp)
    sw $zero, 116($sp)
    sw $zero, 112($sp)
    LOAD $3, $2, 2
    sw $3, 32($sp)
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
    lwc1 $f0, 4($sp)
    mul.s $f5, $f3, $f1
    mul.s $f20, $f3, $f2
    swc1 $f0, 24($sp)
    swc1 $f0, 20($sp)
    swc1 $f0, 16($sp)
    lwc1 $f0, 96($sp)
    swc1 $f0, 80($sp)
$BB0_5:
    lwc1 $f21, 12($sp)
    addiu $3, $zero, 1
$BB0_6:
    mfc1 $1, $f6
    and $1, $1, $15
    mtc1 $1, $f22
    mfc1 $1, $f20
    and $1, $1, $15
    mtc1 $1, $f2
    LOAD $5, $2, 10
    lwc1 $f1, 96($sp)
    FPMIN $f0, $f22, $f2
    lwc1 $f4, 56($sp)
    div.s $f23, $f1, $f5
    div.s $f3, $f1, $f20
    div.s $f1, $f1, $f6
    mfc1 $9, $f3
    mfc1 $11, $f1
    mfc1 $7, $f23
    addu $4, $11, $5
    addu $10, $9, $5
    addu $12, $7, $5
    mfc1 $1, $f5
    and $1, $1, $15
    mtc1 $1, $f29
    FPMIN $f0, $f0, $f29
    c.olt.s $f0, $f4
    mtc1 $12, $f26
    mtc1 $10, $f27
    mtc1 $4, $f28
    bc1f $BB0_12
    nop
    beqz $5, $BB0_13
    nop
    mtc1 $zero, $f4
    c.eq.s $f6, $f4
    bc1f $BB0_14
    mov.s $f24, $f1
    c.eq.s $f20, $f4
    bc1f $BB0_15
    mov.s $f25, $f3
$BB0_10:
    c.eq.s $f5, $f4
    bc1f $BB0_16
    nop
$BB0_11:
    mov.s $f26, $f23
    mov.s $f27, $f3
    j $BB0_17
    mov.s $f28, $f1
$BB0_12:
    mov.s $f25, $f3
    j $BB0_17
    mov.s $f24, $f1
$BB0_13:
    mov.s $f25, $f3
    j $BB0_17
    mov.s $f24, $f1
$BB0_14:
    ori $1, $8, 65535
    lw $10, 36($sp)
    and $1, $11, $1
    lui $11, 32640
    sltu $4, $1, $10
    movn $10, $1, $4
    addu $1, $10, $5
    slt $4, $1, $17
    movn $11, $1, $4
    mfc1 $4, $f6
    lui $1, 32768
    and $4, $4, $1
    or $11, $4, $11
    or $4, $4, $10
    mtc1 $11, $f1
    mtc1 $4, $f24
    c.eq.s $f20, $f4
    bc1t $BB0_10
    mov.s $f25, $f3
$BB0_15:
    ori $1, $8, 65535
    lui $10, 32640
    and $1, $9, $1
    lw $9, 36($sp)
    sltu $4, $1, $9
    movn $9, $1, $4
    addu $1, $9, $5
    slt $4, $1, $17
    movn $10, $1, $4
    mfc1 $4, $f20
    lui $1, 32768
    and $4, $4, $1
    or $10, $4, $10
    or $4, $4, $9
    mtc1 $10, $f3
    mtc1 $4, $f25
    c.eq.s $f5, $f4
    bc1t $BB0_11
    nop
$BB0_16:
    ori $1, $8, 65535
    mov.s $f27, $f3
    mov.s $f28, $f1
    and $1, $7, $1
    lw $7, 36($sp)
    sltu $4, $1, $7
    movn $7, $1, $4
    addu $1, $7, $5
    lui $5, 32640
    slt $4, $1, $17
    movn $5, $1, $4
    mfc1 $4, $f5
    lui $1, 32768
    and $4, $4, $1
    or $5, $4, $5
    or $4, $4, $7
    mtc1 $5, $f26
    mtc1 $4, $f23
$BB0_17:
    c.ule.s $f22, $f29
    addiu $1, $zero, 1
    addiu $4, $zero, 1
    addiu $10, $sp, 112
    swc1 $f17, 148($sp)
    swc1 $f16, 144($sp)
    swc1 $f15, 140($sp)
    swc1 $f5, 136($sp)
    swc1 $f20, 132($sp)
    swc1 $f6, 128($sp)
    andi $21, $3, 1
    movt $1, $zero, $fcc0
    c.ule.s $f22, $f2
    mtc1 $zero, $f22
    movt $4, $zero, $fcc0
    c.ule.s $f2, $f29
    and $1, $4, $1
    addiu $4, $zero, 2
    movf $4, $13, $fcc0
    c.olt.s $f24, $f22
    move $5, $4
    addiu $14, $4, -1
    addiu $4, $zero, 2
    movn $5, $zero, $1
    movn $14, $4, $1
    addiu $7, $5, 1
    xori $9, $5, 2
    sll $1, $14, 2
    movz $7, $zero, $9
    sll $9, $5, 2
    addu $18, $1, $10
    sll $11, $7, 2
    addu $9, $10, $9
    lwc1 $f3, 16($18)
    addu $12, $11, $10
    lwc1 $f1, 16($9)
    lwc1 $f2, 16($12)
    LOAD $f0, $2, 40
    LOAD $f4, $2, 41
    LOAD $f7, $2, 42
    LOAD $f8, $2, 43
    mov.s $f9, $f8
    mov.s $f11, $f4
    LOAD $f10, $2, 44
    movt.s $f9, $f0, $fcc0
    c.olt.s $f25, $f22
    movt.s $f11, $f10, $fcc0
    c.olt.s $f24, $f22
    movt.s $f0, $f8, $fcc0
    c.olt.s $f25, $f22
    sub.s $f9, $f9, $f15
    movt.s $f10, $f4, $fcc0
    c.olt.s $f23, $f22
    sub.s $f11, $f11, $f16
    mul.s $f9, $f28, $f9
    sub.s $f0, $f0, $f15
    sub.s $f4, $f10, $f16
    LOAD $f10, $2, 45
    mul.s $f8, $f25, $f11
    mul.s $f0, $f24, $f0
    FPMAX $f0, $f0, $f8
    mul.s $f4, $f27, $f4
    FPMIN $f4, $f9, $f4
    mov.s $f9, $f10
    movt.s $f9, $f7, $fcc0
    c.olt.s $f23, $f22
    movt.s $f7, $f10, $fcc0
    sub.s $f9, $f9, $f17
    sub.s $f7, $f7, $f17
    mul.s $f9, $f26, $f9
    FPMIN $f9, $f9, $f21
    FPMIN $f4, $f4, $f9
    mul.s $f7, $f23, $f7
    FPMAX $f7, $f7, $f22
    FPMAX $f0, $f0, $f7
    c.ule.s $f0, $f4
    bc1f $BB0_60
    nop
    lwc1 $f0, 96($sp)
    div.s $f29, $f3, $f1
    div.s $f31, $f2, $f1
    sll $1, $7, 1
    sll $3, $14, 1
    sll $4, $5, 1
    swc1 $f5, 104($sp)
    swc1 $f6, 108($sp)
    swc1 $f13, 76($sp)
    addu $fp, $1, $7
    addiu $1, $9, 28
    addu $22, $4, $5
    addu $23, $3, $14
    addiu $4, $zero, 0
    addiu $3, $18, 28
    addiu $7, $12, 28
    addiu $5, $zero, -1
    move $9, $15
    div.s $f0, $f0, $f1
    sw $1, 72($sp)
    swc1 $f0, 84($sp)
    LOAD $11, $4, 46
    and $10, $11, $ra
    bltz $11, $BB0_28
    addiu $19, $sp, 208
$BB0_19:
    lw $1, 60($sp)
    move $14, $4
    addu $18, $10, $1
    LOAD $10, $18, 0
    srl $1, $10, 28
    andi $1, $1, 7
    j $BB0_22
    addiu $20, $1, 1
$BB0_20:
    sll $1, $12, 3
    addiu $14, $14, 1
    addu $1, $19, $1
    swc1 $f1, 4($1)
    sw $11, 0($1)
$BB0_21:
    addiu $1, $20, -1
    slti $10, $20, 2
    addiu $18, $18, 7
    bnez $10, $BB0_46
    move $20, $1
$BB0_22:
    LOAD $f0, $18, 1
    LOAD $f1, $18, 2
    LOAD $f2, $18, 3
    LOAD $f3, $18, 4
    LOAD $f4, $18, 5
    LOAD $f7, $18, 6
    BOXTEST $10, $f1, $f0, $f1, $f2, $f3, $f4, $f7, $f15, $f16, $f17, $f24, $f25, $f23, $f28, $f27, $f26, $f21
    LOAD $11, $18, 0
    beqz $10, $BB0_21
    nop
    slt $1, $4, $14
    beqz $1, $BB0_20
    move $12, $14
    sll $1, $14, 3
    move $12, $14
    addu $10, $19, $1
$BB0_25:
    lwc1 $f0, -4($10)
    c.ole.s $f0, $f1
    bc1f $BB0_20
    nop
    lw $1, -4($10)
    addiu $12, $12, -1
    sw $1, 4($10)
    lw $1, -8($10)
    sw $1, 0($10)
    slt $1, $4, $12
    bnez $1, $BB0_25
    addiu $10, $10, -8
    j $BB0_20
    move $12, $4
$BB0_28:
    sll $1, $10, 1
    sll $10, $10, 3
    lw $6, 48($sp)
    addu $1, $10, $1
    addu $20, $1, $6
    lw $1, 72($sp)
    lwc1 $f2, 0($1)
    j $BB0_31
    nop
$BB0_29:
    mov.s $f21, $f4
    move $9, $10
    move $5, $20
    swc1 $f1, 160($sp)
    swc1 $f3, 156($sp)
    swc1 $f1, 92($sp)
    beqz $21, $BB0_58
    swc1 $f3, 88($sp)
$BB0_30:
    and $1, $12, $16
    bnez $1, $BB0_45
    addiu $20, $20, 10
$BB0_31:
    addu $10, $fp, $20
    lwc1 $f3, 0($7)
    lwc1 $f0, 0($3)
    LOAD $f1, $10, 0
    LOAD $f4, $10, 1
    LOAD $f7, $10, 2
    ori $18, $8, 65535
    addu $10, $23, $20
    LOAD $f8, $10, 0
    LOAD $f9, $10, 1
    LOAD $f11, $10, 2
    sub.s $f10, $f1, $f3
    addu $10, $22, $20
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
    mfc1 $12, $f9
    mfc1 $11, $f10
    mfc1 $6, $f7
    mul.s $f12, $f29, $f1
    and $11, $11, $18
    and $14, $14, $18
    and $6, $6, $18
    sub.s $f30, $f8, $f12
    mul.s $f12, $f31, $f3
    sub.s $f4, $f4, $f12
    mul.s $f12, $f29, $f3
    mfc1 $15, $f30
    and $15, $15, $18
    mtc1 $15, $f14
    sub.s $f9, $f9, $f12
    mul.s $f12, $f31, $f1
    mfc1 $1, $f4
    and $1, $1, $18
    mtc1 $1, $f13
    LOAD $f6, $10, 2
    mfc1 $10, $f0
    sub.s $f10, $f10, $f12
    mfc1 $ra, $f9
    mfc1 $1, $f8
    and $ra, $ra, $18
    and $1, $1, $18
    mtc1 $1, $f8
    and $1, $12, $18
    mtc1 $ra, $f5
    mfc1 $17, $f10
    mtc1 $1, $f18
    FPMAX $f5, $f14, $f5
    FPMAX $f8, $f8, $f18
    LOAD $12, $20, 9
    mtc1 $11, $f18
    and $17, $17, $18
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
    and $11, $11, $18
    and $1, $1, $18
    mtc1 $11, $f6
    sub.s $f11, $f11, $f7
    mtc1 $1, $f7
    and $1, $10, $18
    mfc1 $10, $f1
    sub.s $f12, $f19, $f12
    sub.s $f4, $f4, $f0
    mtc1 $1, $f9
    FPMAX $f14, $f14, $f7
    FPMAX $f5, $f5, $f6
    FPMAX $f6, $f8, $f9
    FPMIN $f10, $f12, $f11
    FPMAX $f7, $f12, $f11
    mtc1 $6, $f8
    mfc1 $1, $f3
    and $10, $10, $18
    mtc1 $14, $f9
    mtc1 $10, $f0
    and $1, $1, $18
    mtc1 $1, $f19
    FPMAX $f0, $f0, $f19
    mfc1 $1, $f13
    and $1, $1, $18
    mtc1 $1, $f19
    FPMAX $f7, $f7, $f4
    FPMAX $f19, $f0, $f19
    FPMAX $f0, $f14, $f5
    FPMAX $f5, $f6, $f19
    FPMAX $f6, $f18, $f9
    FPMIN $f9, $f10, $f4
    FPMAX $f6, $f6, $f8
    FPMAX $f8, $f6, $f5
    mfc1 $6, $f8
    addu $1, $6, $24
    sltu $1, $25, $1
    bnez $1, $BB0_38
    nop
    lwc1 $f10, %gp_rel($CPI0_5)($gp)
    lwc1 $f5, %gp_rel($CPI0_4)($gp)
    mul.s $f6, $f8, $f10
    mul.s $f5, $f8, $f5
    add.s $f0, $f6, $f0
    mul.s $f0, $f5, $f0
    c.ule.s $f7, $f0
    bc1t $BB0_34
    neg.s $f30, $f0
    c.olt.s $f9, $f30
    bc1t $BB0_30
    nop
$BB0_34:
    c.ule.s $f9, $f0
    bc1f $BB0_36
    nop
    c.olt.s $f7, $f30
    bc1f $BB0_38
    nop
$BB0_36:
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
    and $1, $1, $18
    mtc1 $1, $f1
    c.ule.s $f1, $f5
    bc1t $BB0_38
    nop
    lwc1 $f1, 84($sp)
    lwc1 $f3, 96($sp)
    mul.s $f0, $f1, $f0
    add.s $f1, $f12, $f11
    add.s $f1, $f4, $f1
    div.s $f3, $f3, $f1
    mul.s $f12, $f3, $f0
    mul.s $f1, $f4, $f3
    j $BB0_39
    mul.s $f3, $f11, $f3
$BB0_38:
    lwc1 $f1, 104($sp)
    lwc1 $f0, 108($sp)
    EXACT $6, $f12, $f3, $f1, $20, $f15, $f16, $f17, $f0, $f20, $f1
    beqz $6, $BB0_30
    nop
$BB0_39:
    LOAD $f0, $20, 0
    LOAD $f4, $20, 1
    FPMAX $f13, $f0, $f4
    LOAD $f5, $20, 2
    LOAD $f6, $20, 3
    LOAD $f7, $20, 4
    LOAD $f8, $20, 5
    c.olt.s $f24, $f22
    LOAD $f9, $20, 6
    LOAD $f10, $20, 7
    LOAD $f11, $20, 8
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
    bc1f $BB0_30
    nop
    c.olt.s $f4, $f22
    bc1t $BB0_30
    nop
    c.ule.s $f4, $f21
    bc1f $BB0_30
    nop
    lw $1, 100($sp)
    c.ult.s $f4, $f21
    bc1t $BB0_29
    and $10, $12, $1
    slt $1, $10, $9
    beqz $1, $BB0_30
    nop
    j $BB0_29
    nop
$BB0_45:
    lw $15, 44($sp)
    lw $ra, 40($sp)
    move $14, $4
$BB0_46:
    sll $1, $14, 3
    negu $4, $14
    addu $10, $19, $1
$BB0_47:
    addiu $4, $4, 1
    beq $4, $13, $BB0_51
    nop
    lwc1 $f0, -4($10)
    addiu $11, $10, -8
    c.ule.s $f0, $f21
    bc1f $BB0_47
    move $10, $11
    lw $11, 0($11)
    negu $4, $4
    and $10, $11, $ra
    bgez $11, $BB0_19
    addiu $19, $sp, 208
    j $BB0_28
    nop
$BB0_51:
    beqz $21, $BB0_62
    nop
    lwc1 $f13, 76($sp)
    bltz $5, $BB0_69
    lui $17, 32640
    LOAD $f2, $5, 0
    LOAD $f26, $5, 1
    LOAD $f25, $5, 2
    sub.s $f17, $f26, $f2
    LOAD $f15, $5, 3
    LOAD $f11, $5, 4
    sub.s $f1, $f11, $f15
    LOAD $f28, $5, 5
    ori $3, $8, 65535
    sub.s $f16, $f28, $f15
    sub.s $f23, $f25, $f2
    lwc1 $f5, %gp_rel($CPI0_7)($gp)
    mfc1 $4, $f17
    mfc1 $1, $f1
    and $4, $4, $3
    and $1, $1, $3
    mtc1 $4, $f0
    mtc1 $1, $f3
    LOAD $f21, $5, 6
    LOAD $f27, $5, 7
    LOAD $f12, $5, 8
    mfc1 $4, $f23
    sub.s $f24, $f12, $f21
    FPMAX $f0, $f0, $f3
    sub.s $f3, $f27, $f21
    mfc1 $1, $f16
    and $4, $4, $3
    mtc1 $4, $f4
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
    mfc1 $4, $f0
    and $1, $4, $17
    lui $4, 32512
    subu $4, $4, $1
    mtc1 $4, $f0
    mul.s $f6, $f24, $f0
    mul.s $f7, $f17, $f0
    mul.s $f8, $f23, $f0
    mul.s $f9, $f3, $f0
    mul.s $f13, $f16, $f0
    mul.s $f14, $f1, $f0
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
    bc1f $BB0_55
    nop
    lwc1 $f0, 104($sp)
    neg.s $f14, $f20
    neg.s $f13, $f0
    lwc1 $f0, 108($sp)
    j $BB0_56
    neg.s $f18, $f0
$BB0_55:
    lwc1 $f6, 108($sp)
    mul.s $f5, $f20, $f4
    lui $6, 32768
    mul.s $f6, $f6, $f0
    add.s $f5, $f6, $f5
    lwc1 $f6, 104($sp)
    mul.s $f6, $f6, $f7
    add.s $f5, $f6, $f5
    mfc1 $4, $f5
    FPINVSQRT $f5, $f8
    and $4, $4, $6
    mfc1 $5, $f5
    xor $1, $5, $4
    xor $4, $1, $6
    mtc1 $4, $f5
    mul.s $f13, $f7, $f5
    mul.s $f14, $f4, $f5
    mul.s $f18, $f0, $f5
$BB0_56:
    mfc1 $1, $f15
    mfc1 $10, $f26
    mfc1 $5, $f21
    mfc1 $9, $f2
    mfc1 $4, $f11
    mfc1 $7, $f28
    lwc1 $f7, %gp_rel($CPI0_8)($gp)
    lwc1 $f19, 80($sp)
    mfc1 $6, $f12
    swc1 $f13, 172($sp)
    swc1 $f14, 168($sp)
    swc1 $f18, 164($sp)
    and $1, $1, $3
    and $10, $10, $3
    and $5, $5, $3
    and $9, $9, $3
    and $4, $4, $3
    mul.s $f19, $f19, $f7
    and $7, $7, $3
    and $6, $6, $3
    mtc1 $1, $f0
    mfc1 $1, $f27
    mtc1 $10, $f9
    mtc1 $5, $f5
    mtc1 $9, $f8
    mtc1 $4, $f4
    mfc1 $4, $f25
    and $1, $1, $3
    and $4, $4, $3
    mtc1 $1, $f6
    FPMAX $f7, $f8, $f9
    lwc1 $f9, 88($sp)
    FPMAX $f5, $f5, $f6
    FPMAX $f0, $f0, $f4
    mtc1 $6, $f4
    swc1 $f19, 124($sp)
    mtc1 $7, $f6
    FPMAX $f0, $f0, $f6
    FPMAX $f4, $f5, $f4
    mtc1 $4, $f5
    LOAD $f8, $2, 28
    mul.s $f6, $f17, $f9
    FPMAX $f0, $f0, $f4
    FPMAX $f4, $f7, $f5
    LOAD $f5, $2, 29
    lwc1 $f10, 92($sp)
    mul.s $f1, $f1, $f9
    mul.s $f3, $f3, $f9
    LOAD $f11, $2, 30
    swc1 $f14, 68($sp)
    swc1 $f18, 64($sp)
    FPMAX $f0, $f4, $f0
    mul.s $f7, $f23, $f10
    mul.s $f9, $f16, $f10
    mul.s $f10, $f24, $f10
    add.s $f2, $f2, $f6
    lwc1 $f6, %gp_rel($CPI0_9)($gp)
    add.s $f1, $f15, $f1
    add.s $f3, $f21, $f3
    mul.s $f0, $f0, $f6
    add.s $f2, $f2, $f7
    add.s $f1, $f1, $f9
    add.s $f3, $f3, $f10
    mul.s $f4, $f18, $f0
    mul.s $f6, $f14, $f0
    mul.s $f0, $f13, $f0
    add.s $f15, $f4, $f2
    add.s $f16, $f6, $f1
    add.s $f17, $f0, $f3
    sub.s $f2, $f8, $f15
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
    mfc1 $3, $f1
    and $5, $3, $17
    lui $1, 32512
    subu $3, $1, $5
    mtc1 $3, $f1
    mul.s $f20, $f5, $f1
    mul.s $f6, $f2, $f1
    mul.s $f5, $f0, $f1
    mul.s $f3, $f14, $f20
    mul.s $f2, $f18, $f6
    mul.s $f0, $f13, $f5
    add.s $f2, $f2, $f3
    add.s $f0, $f0, $f2
    c.ule.s $f0, $f22
    bc1t $BB0_67
    nop
    addiu $3, $zero, 0
    LOAD $f2, $3, 11
    mul.s $f1, $f1, $f2
    mul.s $f3, $f6, $f6
    swc1 $f19, 80($sp)
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
    swc1 $f0, 52($sp)
    j $BB0_6
    swc1 $f0, 152($sp)
$BB0_58:
    lw $15, 44($sp)
    lw $ra, 40($sp)
    lwc1 $f13, 76($sp)
    lwc1 $f19, 80($sp)
    swc1 $f1, 92($sp)
    swc1 $f3, 88($sp)
    move $5, $20
    lwc1 $f12, 68($sp)
    lwc1 $f14, 64($sp)
    bgez $5, $BB0_63
    lui $17, 32640
    j $BB0_65
    nop
$BB0_60:
    lwc1 $f12, 68($sp)
    lwc1 $f14, 64($sp)
    lwc1 $f19, 80($sp)
    beqz $21, $BB0_65
    nop
    j $BB0_70
    nop
$BB0_62:
    lwc1 $f13, 76($sp)
    lwc1 $f19, 80($sp)
    lwc1 $f12, 68($sp)
    lwc1 $f14, 64($sp)
    bltz $5, $BB0_65
    lui $17, 32640
$BB0_63:
    lw $3, 28($sp)
    lw $4, 32($sp)
    bnez $4, $BB0_68
    nop
    j $BB0_2
    nop
$BB0_65:
    LOAD $f0, $2, 31
    lwc1 $f1, 52($sp)
    lwc1 $f2, 16($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 16($sp)
    swc1 $f2, 112($sp)
    LOAD $f0, $2, 32
    lwc1 $f2, 20($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 20($sp)
    swc1 $f2, 116($sp)
    LOAD $f0, $2, 33
    lw $3, 28($sp)
    lw $4, 32($sp)
    mul.s $f0, $f1, $f0
    lwc1 $f1, 24($sp)
    add.s $f1, $f1, $f0
    swc1 $f1, 24($sp)
    bnez $4, $BB0_68
    swc1 $f1, 120($sp)
    j $BB0_2
    nop
$BB0_67:
    lw $3, 28($sp)
    lwc1 $f12, 68($sp)
    lwc1 $f14, 64($sp)
    lw $4, 32($sp)
    beqz $4, $BB0_2
    nop
$BB0_68:
    swc1 $f19, 80($sp)
    RAND $f0
    RAND $f1
    mfc1 $3, $f13
    lwc1 $f2, %gp_rel($CPI0_11)($gp)
    lwc1 $f6, %gp_rel($CPI0_12)($gp)
    lwc1 $f11, 96($sp)
    mul.s $f7, $f12, $f12
    addiu $4, $4, -1
    swc1 $f14, 64($sp)
    swc1 $f12, 68($sp)
    lui $1, 32768
    sw $4, 32($sp)
    and $1, $3, $1
    lui $3, 16256
    mul.s $f1, $f1, $f2
    sub.s $f3, $f11, $f0
    sqrt.s $f0, $f0
    or $3, $1, $3
    mtc1 $3, $f2
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
    add.s $f6, $f9, $f1
    mul.s $f1, $f5, $f12
    j $BB0_5
    sub.s $f5, $f0, $f1
$BB0_69:
    lwc1 $f12, 68($sp)
    lwc1 $f14, 64($sp)
    lwc1 $f19, 80($sp)
$BB0_70:
    LOAD $f0, $2, 34
    lwc1 $f3, 16($sp)
    mul.s $f0, $f19, $f0
    add.s $f3, $f3, $f0
    swc1 $f3, 112($sp)
    LOAD $f0, $2, 35
    lwc1 $f2, 20($sp)
    mul.s $f0, $f19, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 116($sp)
    LOAD $f0, $2, 36
    lwc1 $f1, 24($sp)
    lw $3, 28($sp)
    mul.s $f0, $f19, $f0
    add.s $f1, $f1, $f0
    j $BB0_3
    swc1 $f1, 120($sp)
$BB0_71:
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
