$CPI0_0:
    .4byte 0x3f800000
main:
    addiu $sp, $sp, -544
    sdc1 $f26, 536($sp)
    sdc1 $f24, 528($sp)
    sdc1 $f22, 520($sp)
    sdc1 $f20, 512($sp)
    addiu $5, $zero, 0
    LOAD $2, $5, 8
    LOAD $3, $5, 14
    LOAD $4, $5, 7
    LOAD $5, $5, 1
    ATOMIC_INC $6, 0
    slt $1, $6, $5
    beqz $1, $BB0_23
    nop
    addiu $7, $sp, 0
    lwc1 $f0, %gp_rel($CPI0_0)($gp)
    mtc1 $zero, $f1
    addiu $9, $sp, 256
    j $BB0_3
    addiu $8, $7, -4
$BB0_2:
    sll $1, $6, 1
    addu $6, $1, $4
    STORE $f4, $6, 0
    STORE $10, $6, 1
    ATOMIC_INC $6, 0
    slt $1, $6, $5
    beqz $1, $BB0_23
    nop
$BB0_3:
    sll $1, $6, 3
    addiu $10, $zero, -1
    addiu $14, $zero, 0
    addu $11, $1, $3
    LOAD $f2, $11, 0
    LOAD $f3, $11, 1
    LOAD $f5, $11, 2
    LOAD $f6, $11, 3
    LOAD $f7, $11, 4
    LOAD $f8, $11, 5
    LOAD $f9, $11, 6
    div.s $f10, $f0, $f7
    div.s $f11, $f0, $f8
    div.s $f12, $f0, $f9
    LOAD $f4, $11, 7
    addiu $11, $zero, 0
$BB0_4:
    sll $1, $11, 2
    addu $13, $8, $1
    addu $12, $9, $1
$BB0_5:
    sll $1, $14, 3
    addu $14, $1, $2
    LOAD $15, $14, 6
    LOAD $14, $14, 7
    bgez $15, $BB0_12
    nop
    sll $1, $14, 3
    addu $15, $1, $2
    LOAD $f13, $15, 0
    LOAD $f14, $15, 1
    LOAD $f15, $15, 2
    sub.s $f13, $f13, $f2
    sub.s $f14, $f14, $f3
    sub.s $f15, $f15, $f5
    addiu $24, $15, 8
    mul.s $f16, $f10, $f13
    LOAD $f13, $15, 3
    LOAD $f17, $15, 4
    LOAD $f18, $15, 5
    mul.s $f14, $f11, $f14
    mul.s $f15, $f12, $f15
    sub.s $f13, $f13, $f2
    sub.s $f17, $f17, $f3
    sub.s $f18, $f18, $f5
    mul.s $f19, $f10, $f13
    FPMIN $f13, $f16, $f19
    mul.s $f17, $f11, $f17
    FPMIN $f20, $f14, $f17
    mul.s $f18, $f12, $f18
    FPMAX $f13, $f13, $f20
    FPMIN $f20, $f15, $f18
    FPMAX $f13, $f13, $f20
    FPMAX $f13, $f13, $f1
    FPMAX $f16, $f16, $f19
    FPMAX $f14, $f14, $f17
    FPMIN $f14, $f16, $f14
    FPMAX $f15, $f15, $f18
    FPMIN $f14, $f14, $f15
    FPMIN $f14, $f14, $f4
    LOAD $f15, $24, 0
    LOAD $f16, $24, 1
    LOAD $f17, $24, 2
    LOAD $f18, $24, 3
    LOAD $f19, $24, 4
    LOAD $f20, $24, 5
    c.ole.s $f13, $f14
    sub.s $f15, $f15, $f2
    sub.s $f16, $f16, $f3
    sub.s $f19, $f19, $f3
    sub.s $f17, $f17, $f5
    sub.s $f20, $f20, $f5
    mul.s $f21, $f10, $f15
    sub.s $f15, $f18, $f2
    mul.s $f16, $f11, $f16
    mul.s $f19, $f11, $f19
    mul.s $f17, $f12, $f17
    mul.s $f20, $f12, $f20
    mul.s $f18, $f10, $f15
    FPMIN $f15, $f21, $f18
    FPMIN $f22, $f16, $f19
    FPMAX $f15, $f15, $f22
    FPMIN $f22, $f17, $f20
    FPMAX $f15, $f15, $f22
    FPMAX $f15, $f15, $f1
    FPMAX $f18, $f21, $f18
    FPMAX $f16, $f16, $f19
    FPMIN $f16, $f18, $f16
    FPMAX $f17, $f17, $f20
    FPMIN $f16, $f16, $f17
    FPMIN $f16, $f16, $f4
    bc1f $BB0_8
    nop
    c.ole.s $f15, $f16
    bc1t $BB0_11
    nop
$BB0_8:
    c.ole.s $f13, $f14
    bc1t $BB0_5
    nop
    c.ole.s $f15, $f16
    bc1f $BB0_14
    nop
    j $BB0_5
    addiu $14, $14, 1
$BB0_11:
    mov.s $f14, $f15
    addiu $1, $14, 1
    c.olt.s $f15, $f13
    sll $24, $11, 2
    addiu $13, $13, 4
    addiu $12, $12, 4
    addiu $11, $11, 1
    move $15, $1
    addu $25, $9, $24
    addu $24, $7, $24
    movt $15, $14, $fcc0
    movt.s $f14, $f13, $fcc0
    c.olt.s $f15, $f13
    sw $15, 0($25)
    movt $14, $1, $fcc0
    j $BB0_5
    swc1 $f14, 0($24)
$BB0_12:
    bnez $15, $BB0_18
    nop
$BB0_13:
    bgez $10, $BB0_2
    nop
$BB0_14:
    blez $11, $BB0_2
    nop
    lwc1 $f13, 0($13)
    addiu $1, $13, -4
    addiu $11, $11, -1
    addiu $12, $12, -4
    c.olt.s $f13, $f4
    bc1f $BB0_14
    move $13, $1
    lw $14, 0($12)
    j $BB0_4
    nop
$BB0_17:
    addiu $15, $15, -1
    beqz $15, $BB0_13
    addiu $14, $14, 11
$BB0_18:
    LOAD $f17, $14, 0
    LOAD $f19, $14, 1
    LOAD $f21, $14, 2
    LOAD $f13, $14, 3
    LOAD $f15, $14, 4
    LOAD $f14, $14, 5
    LOAD $f20, $14, 6
    LOAD $f22, $14, 7
    LOAD $f24, $14, 8
    sub.s $f14, $f14, $f24
    sub.s $f13, $f13, $f20
    sub.s $f15, $f15, $f22
    sub.s $f19, $f19, $f22
    mul.s $f16, $f9, $f13
    mul.s $f18, $f7, $f14
    mul.s $f25, $f8, $f14
    sub.s $f23, $f16, $f18
    mul.s $f18, $f9, $f15
    sub.s $f16, $f3, $f22
    sub.s $f25, $f25, $f18
    sub.s $f18, $f2, $f20
    sub.s $f20, $f17, $f20
    mul.s $f26, $f16, $f23
    mul.s $f22, $f19, $f23
    mul.s $f23, $f8, $f13
    mul.s $f17, $f20, $f25
    mul.s $f27, $f18, $f25
    mul.s $f25, $f7, $f15
    sub.s $f25, $f25, $f23
    sub.s $f23, $f21, $f24
    add.s $f17, $f17, $f22
    sub.s $f24, $f5, $f24
    add.s $f22, $f27, $f26
    mul.s $f21, $f23, $f25
    mul.s $f25, $f24, $f25
    add.s $f17, $f21, $f17
    add.s $f22, $f25, $f22
    div.s $f17, $f0, $f17
    mul.s $f21, $f22, $f17
    c.olt.s $f21, $f1
    bc1t $BB0_17
    nop
    c.ule.s $f21, $f0
    bc1f $BB0_17
    nop
    mul.s $f22, $f18, $f23
    mul.s $f25, $f20, $f24
    mul.s $f23, $f16, $f23
    mul.s $f24, $f19, $f24
    mul.s $f16, $f20, $f16
    mul.s $f18, $f18, $f19
    sub.s $f22, $f25, $f22
    sub.s $f23, $f23, $f24
    sub.s $f16, $f18, $f16
    mul.s $f25, $f8, $f22
    mul.s $f24, $f7, $f23
    mul.s $f18, $f9, $f16
    add.s $f24, $f24, $f25
    add.s $f18, $f18, $f24
    mul.s $f18, $f18, $f17
    c.olt.s $f18, $f1
    bc1t $BB0_17
    nop
    add.s $f18, $f21, $f18
    c.ule.s $f18, $f0
    bc1f $BB0_17
    nop
    mul.s $f15, $f15, $f22
    mul.s $f13, $f13, $f23
    mul.s $f14, $f14, $f16
    addiu $1, $zero, 1
    addiu $24, $zero, 1
    add.s $f13, $f13, $f15
    add.s $f13, $f14, $f13
    mul.s $f13, $f13, $f17
    c.olt.s $f13, $f4
    movf $1, $zero, $fcc0
    c.ule.s $f13, $f6
    movt $24, $zero, $fcc0
    and $1, $24, $1
    movn.s $f4, $f13, $1
    j $BB0_17
    movn $10, $14, $1
$BB0_23:
    ldc1 $f20, 512($sp)
    ldc1 $f22, 520($sp)
    ldc1 $f24, 528($sp)
    ldc1 $f26, 536($sp)
    addiu $2, $zero, 0
    jr $ra
    addiu $sp, $sp, 544
