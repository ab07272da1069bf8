main:                           #: start
    addiu $sp, $sp, -2576
    sdc1 $f30, 2568($sp)
    sdc1 $f28, 2560($sp)
    sdc1 $f26, 2552($sp)
    sdc1 $f24, 2544($sp)
    sdc1 $f22, 2536($sp)
    sdc1 $f20, 2528($sp)
    sw $ra, 2524($sp)
    sw $fp, 2520($sp)
    sw $23, 2516($sp)
    sw $22, 2512($sp)
    sw $21, 2508($sp)
    sw $20, 2504($sp)
    sw $19, 2500($sp)
    sw $18, 2496($sp)
    sw $17, 2492($sp)
    sw $16, 2488($sp)
    addiu $2, $zero, 0
    LOAD $3, $2, 1              #: parameters
    LOAD $4, $2, 8              #: parameters
    LOAD $5, $2, 9              #: parameters
    sw $5, 48($sp)
    ATOMIC_INC $6, 0
    slt $1, $6, $3
    beqz $1, $BB0_44            #: no_more
    sw $3, 8($sp)
    lwc1 $f0, %gp_rel($CPI0_0)($gp)
    lui $1, 32767
    lwc1 $f30, %gp_rel($CPI0_1)($gp)
    addiu $9, $zero, 1
    addiu $11, $sp, 88
    lui $5, 32768
    lui $14, 2048
    ori $8, $1, 65535
    lui $1, 4095
    swc1 $f0, 4($sp)
    mtc1 $zero, $f0
    swc1 $f30, 84($sp)
    swc1 $f0, 0($sp)
    lwc1 $f0, %gp_rel($CPI0_2)($gp)
    swc1 $f0, 28($sp)
    j $BB0_4
    ori $13, $1, 65535
$BB0_2:
    lwc1 $f1, 24($sp)
    lwc1 $f2, 20($sp)
    lwc1 $f3, 16($sp)
$BB0_3:
    lw $3, 12($sp)
    sll $1, $3, 1
    addu $3, $1, $3
    LOAD $6, $2, 7              #: parameters
    addu $3, $6, $3
    STORE $f3, $3, 0            #: pixel
    STORE $f2, $3, 1            #: pixel
    STORE $f1, $3, 2            #: pixel
    ATOMIC_INC $6, 0
    lw $1, 8($sp)
    slt $1, $6, $1
    beqz $1, $BB0_44            #: no_more
    nop
$BB0_4:
    mtc1 $6, $f0
    sw $6, 12($sp)
    LOAD $f2, $2, 3             #: parameters
    cvt.s.w $f0, $f0
    mul.s $f2, $f2, $f0
    trunc.w.s $f2, $f2
    mfc1 $1, $f2
    mtc1 $1, $f2
    LOAD $f3, $2, 4             #: parameters
    LOAD $f6, $2, 19            #: parameters
    LOAD $f7, $2, 22            #: parameters
    LOAD $f8, $2, 25            #: parameters
    lwc1 $f1, 4($sp)
    LOAD $f10, $2, 20           #: parameters
    LOAD $f11, $2, 23           #: parameters
    LOAD $f12, $2, 26           #: parameters
    cvt.s.w $f2, $f2
    add.s $f9, $f2, $f1
    mul.s $f2, $f3, $f2
    sub.s $f0, $f0, $f2
    mul.s $f12, $f9, $f12
    mul.s $f8, $f9, $f8
    add.s $f0, $f0, $f1
    mul.s $f2, $f0, $f11
    mul.s $f7, $f7, $f0
    add.s $f2, $f10, $f2
    add.s $f6, $f6, $f7
    add.s $f6, $f8, $f6
    add.s $f2, $f2, $f12
    LOAD $f8, $2, 21            #: parameters
    mul.s $f3, $f2, $f2
    mul.s $f7, $f6, $f6
    add.s $f3, $f7, $f3
    LOAD $f7, $2, 24            #: parameters
    mul.s $f0, $f0, $f7
    LOAD $f10, $2, 27           #: parameters
    mul.s $f9, $f9, $f10
    LOAD $f13, $2, 16           #: parameters
    LOAD $f14, $2, 17           #: parameters
    LOAD $f15, $2, 18           #: parameters
    lui $1, 16256
    sw $1, 100($sp)
    sw $zero, 96($sp)
    sw $zero, 92($sp)
    sw $zero, 88($sp)
    LOAD $3, $2, 2              #: parameters
    sw $3, 32($sp)
    swc1 $f30, 64($sp)
    add.s $f0, $f8, $f0
    add.s $f0, $f0, $f9
    mul.s $f7, $f0, $f0
    add.s $f3, $f3, $f7
    FPINVSQRT $f3, $f3
    mul.s $f4, $f3, $f0
    mul.s $f9, $f2, $f3
    mul.s $f6, $f6, $f3
    lwc1 $f0, 0($sp)
    swc1 $f0, 24($sp)
    swc1 $f0, 20($sp)
    swc1 $f0, 16($sp)
$BB0_5:
    lwc1 $f20, 28($sp)
    addiu $24, $zero, 1
$BB0_6:                         #: ray
    mfc1 $1, $f4
    mfc1 $3, $f9
    addiu $7, $zero, 2
    div.s $f22, $f30, $f6
    div.s $f21, $f30, $f9
    div.s $f23, $f30, $f4
    swc1 $f15, 124($sp)
    swc1 $f14, 120($sp)
    swc1 $f13, 116($sp)
    swc1 $f4, 112($sp)
    swc1 $f9, 108($sp)
    swc1 $f6, 104($sp)
    swc1 $f9, 56($sp)
    swc1 $f6, 60($sp)
    swc1 $f4, 52($sp)
    mtc1 $zero, $f1
    and $1, $1, $8
    and $3, $3, $8
    mtc1 $1, $f0
    mfc1 $1, $f6
    mtc1 $3, $f3
    addiu $3, $zero, 1
    and $1, $1, $8
    mtc1 $1, $f2
    addiu $1, $zero, 1
    c.ule.s $f2, $f0
    movt $1, $zero, $fcc0
    c.ule.s $f2, $f3
    movt $3, $zero, $fcc0
    c.ule.s $f3, $f0
    movf $7, $9, $fcc0
    and $6, $3, $1
    move $25, $7
    movn $25, $zero, $6
    sll $1, $25, 2
    addiu $3, $25, 1
    addu $19, $11, $1
    mfc1 $16, $f22
    mfc1 $17, $f21
    xori $1, $25, 2
    addiu $17, $17, 4
    addiu $16, $16, 4
    lwc1 $f0, 16($19)
    movz $3, $zero, $1
    mfc1 $18, $f23
    mtc1 $17, $f26
    mtc1 $16, $f25
    addiu $17, $7, -1
    addiu $18, $18, 4
    mtc1 $18, $f24
    sll $1, $3, 2
    addu $21, $1, $11
    addiu $1, $zero, 2
    movn $17, $1, $6
    lwc1 $f2, 16($21)
    sll $1, $17, 2
    addu $20, $1, $11
    lwc1 $f3, 16($20)
    LOAD $f6, $2, 40            #: parameters
    LOAD $f7, $2, 41            #: parameters
    LOAD $f8, $2, 42            #: parameters
    LOAD $f9, $2, 43            #: parameters
    LOAD $f28, $2, 44           #: parameters
    LOAD $f29, $2, 45           #: parameters
    swc1 $f1, 76($sp)
    sub.s $f6, $f6, $f13
    sub.s $f9, $f9, $f13
    sub.s $f7, $f7, $f14
    sub.s $f28, $f28, $f14
    sub.s $f8, $f8, $f15
    mul.s $f11, $f25, $f6
    mul.s $f27, $f25, $f9
    mul.s $f6, $f22, $f6
    mul.s $f9, $f22, $f9
    mul.s $f10, $f26, $f7
    mul.s $f7, $f21, $f7
    FPMAX $f11, $f11, $f27
    mul.s $f27, $f26, $f28
    FPMIN $f6, $f6, $f9
    FPMAX $f9, $f10, $f27
    mul.s $f10, $f21, $f28
    FPMIN $f7, $f7, $f10
    FPMIN $f9, $f11, $f9
    sub.s $f11, $f29, $f15
    FPMAX $f6, $f6, $f7
    mul.s $f10, $f24, $f8
    mul.s $f7, $f23, $f8
    mul.s $f27, $f24, $f11
    FPMAX $f10, $f10, $f27
    mul.s $f8, $f23, $f11
    FPMIN $f7, $f7, $f8
    FPMIN $f10, $f10, $f20
    FPMAX $f7, $f7, $f1
    FPMIN $f9, $f9, $f10
    FPMAX $f6, $f6, $f7
    c.ule.s $f6, $f9
    bc1f $BB0_37                #: root_missed
    nop
    div.s $f0, $f30, $f0
    sll $6, $25, 1
    sll $1, $3, 1
    addiu $fp, $zero, 0
    addiu $19, $19, 28
    addiu $20, $20, 28
    addiu $21, $21, 28
    addu $16, $6, $25
    sll $6, $17, 1
    addu $18, $1, $3
    addiu $25, $zero, -1
    addu $17, $6, $17
    mul.s $f28, $f0, $f3
    mul.s $f29, $f2, $f0
    swc1 $f0, 80($sp)
    LOAD $ra, $fp, 46           #: parameters
$BB0_8:
    sll $1, $fp, 2
    sll $3, $fp, 3
    negu $22, $fp
    addu $1, $3, $1
    addiu $3, $sp, 184
    j $BB0_10
    addu $23, $3, $1
$BB0_9:
    beqz $6, $BB0_26            #: !hit_right
    move $ra, $7
$BB0_10:                        #: node
    bltz $ra, $BB0_14           #: leaf
    and $6, $ra, $13
    sll $1, $6, 3
    subu $1, $1, $6
    addu $6, $1, $4
    LOAD $ra, $6, 0             #: node
    LOAD $f0, $6, 1             #: node
    LOAD $f2, $6, 2             #: node
    LOAD $f3, $6, 3             #: node
    LOAD $f6, $6, 4             #: node
    LOAD $f7, $6, 5             #: node
    LOAD $f8, $6, 6             #: node
    BOXTEST $10, $f0, $f0, $f2, $f3, $f6, $f7, $f8
    LOAD $7, $6, 7              #: node
    LOAD $f2, $6, 8             #: node
    LOAD $f3, $6, 9             #: node
    LOAD $f6, $6, 10            #: node
    LOAD $f7, $6, 11            #: node
    LOAD $f8, $6, 12            #: node
    LOAD $f9, $6, 13            #: node
    BOXTEST $6, $f2, $f2, $f3, $f6, $f7, $f8, $f9
    beqz $10, $BB0_9            #: !hit_left
    nop
    beqz $6, $BB0_10            #: !hit_right
    nop
    mov.s $f3, $f2
    c.olt.s $f2, $f0
    move $1, $7
    sll $6, $fp, 2
    sll $10, $fp, 3
    addiu $23, $23, 12
    addiu $22, $22, -1
    addiu $fp, $fp, 1
    addu $6, $10, $6
    movt $1, $ra, $fcc0
    addu $6, $3, $6
    movt.s $f3, $f0, $fcc0
    c.olt.s $f2, $f0
    movt $ra, $7, $fcc0
    swc1 $f3, 4($6)
    j $BB0_10
    sw $1, 0($6)
$BB0_14:
    sll $1, $6, 1
    sll $3, $6, 3
    lwc1 $f30, 0($19)
    addu $1, $3, $1
    lw $3, 48($sp)
    j $BB0_16
    addu $fp, $1, $3
$BB0_15:
    and $1, $ra, $14
    bnez $1, $BB0_26            #: last
    addiu $fp, $fp, 10
$BB0_16:                        #: triangle
    addu $3, $18, $fp
    lwc1 $f2, 0($21)
    lwc1 $f0, 0($20)
    LOAD $f3, $3, 0             #: row0
    LOAD $f6, $3, 1             #: row0
    LOAD $f7, $3, 2             #: row0
    lwc1 $f9, %gp_rel($CPI0_3)($gp)
    addu $3, $17, $fp
    LOAD $f8, $3, 0             #: row1
    LOAD $f10, $3, 1            #: row1
    LOAD $f31, $3, 2            #: row1
    sub.s $f6, $f6, $f2
    sub.s $f11, $f7, $f2
    addu $3, $16, $fp
    LOAD $f7, $3, 0             #: row2
    LOAD $f12, $3, 1            #: row2
    sub.s $f17, $f3, $f2
    sub.s $f2, $f12, $f30
    LOAD $f16, $3, 2            #: row2
    sub.s $f10, $f10, $f0
    sub.s $f8, $f8, $f0
    sub.s $f0, $f31, $f0
    sub.s $f7, $f7, $f30
    mul.s $f3, $f29, $f2
    mul.s $f5, $f28, $f2
    mfc1 $1, $f17
    mfc1 $ra, $f8
    mfc1 $6, $f10
    mfc1 $10, $f6
    mfc1 $3, $f11
    and $12, $1, $8
    and $6, $6, $8
    and $ra, $ra, $8
    and $3, $3, $8
    mtc1 $6, $f1
    mfc1 $6, $f0
    mtc1 $ra, $f18
    sub.s $f12, $f6, $f3
    sub.s $f3, $f16, $f30
    mul.s $f16, $f29, $f7
    sub.s $f5, $f10, $f5
    lwc1 $f6, %gp_rel($CPI0_4)($gp)
    sub.s $f16, $f17, $f16
    mul.s $f17, $f28, $f7
    mfc1 $7, $f12
    mul.s $f31, $f29, $f3
    mfc1 $1, $f16
    sub.s $f17, $f8, $f17
    and $1, $1, $8
    mtc1 $1, $f8
    and $1, $7, $8
    and $7, $10, $8
    mfc1 $15, $f17
    mtc1 $1, $f19
    mfc1 $1, $f5
    and $15, $15, $8
    and $1, $1, $8
    mtc1 $1, $f10
    mtc1 $15, $f4
    FPMAX $f1, $f18, $f1
    LOAD $ra, $fp, 9            #: triangle
    mtc1 $12, $f18
    FPMAX $f4, $f4, $f10
    FPMAX $f10, $f8, $f19
    mul.s $f19, $f28, $f3
    sub.s $f8, $f11, $f31
    sub.s $f0, $f0, $f19
    mfc1 $1, $f8
    mul.s $f11, $f17, $f8
    mul.s $f27, $f5, $f8
    and $1, $1, $8
    mul.s $f31, $f12, $f0
    mul.s $f19, $f16, $f0
    mfc1 $10, $f0
    mul.s $f0, $f16, $f5
    mul.s $f5, $f17, $f12
    mtc1 $1, $f12
    and $1, $6, $8
    mfc1 $6, $f7
    mtc1 $1, $f16
    FPMAX $f1, $f1, $f16
    FPMAX $f12, $f10, $f12
    and $10, $10, $8
    and $6, $6, $8
    mtc1 $7, $f16
    sub.s $f8, $f27, $f31
    sub.s $f31, $f19, $f11
    mtc1 $10, $f11
    FPMAX $f4, $f4, $f11
    FPMIN $f17, $f8, $f31
    FPMAX $f10, $f8, $f31
    sub.s $f0, $f5, $f0
    mtc1 $6, $f5
    mfc1 $1, $f2
    mtc1 $3, $f11
    and $1, $1, $8
    mtc1 $1, $f19
    FPMAX $f5, $f5, $f19
    mfc1 $1, $f3
    and $1, $1, $8
    mtc1 $1, $f19
    FPMAX $f5, $f5, $f19
    FPMAX $f1, $f1, $f5
    FPMAX $f4, $f12, $f4
    FPMAX $f10, $f10, $f0
    FPMAX $f5, $f18, $f16
    FPMAX $f5, $f5, $f11
    FPMAX $f1, $f5, $f1
    mul.s $f5, $f1, $f6
    mul.s $f1, $f1, $f9
    FPMIN $f6, $f17, $f0
    add.s $f4, $f5, $f4
    mul.s $f11, $f1, $f4
    c.ule.s $f10, $f11
    bc1t $BB0_18                #: negative
    neg.s $f9, $f11
    c.olt.s $f6, $f9
    bc1t $BB0_15                #: outside
    nop
$BB0_18:
    c.ole.s $f6, $f11
    bc1f $BB0_21                #: positive
    nop
    c.ult.s $f10, $f9
    bc1t $BB0_21                #: !exact
    nop
    EXACT $f8, $f31, $f0, $f7
$BB0_21:
    mul.s $f1, $f8, $f7
    mul.s $f2, $f2, $f31
    mul.s $f3, $f3, $f0
    add.s $f1, $f2, $f1
    add.s $f2, $f31, $f8
    add.s $f1, $f3, $f1
    LOAD $f3, $fp, 0            #: triangle
    LOAD $f4, $fp, 1            #: triangle
    LOAD $f5, $fp, 2            #: triangle
    LOAD $f6, $fp, 3            #: triangle
    LOAD $f7, $fp, 4            #: triangle
    lwc1 $f8, 80($sp)
    add.s $f2, $f0, $f2
    FPMIN $f16, $f6, $f7
    FPMIN $f12, $f3, $f4
    FPMAX $f6, $f6, $f7
    FPMAX $f3, $f3, $f4
    FPMIN $f12, $f12, $f5
    FPMAX $f3, $f3, $f5
    sub.s $f12, $f12, $f13
    sub.s $f3, $f3, $f13
    mul.s $f1, $f8, $f1
    lwc1 $f8, 84($sp)
    div.s $f2, $f8, $f2
    LOAD $f8, $fp, 5            #: triangle
    FPMIN $f16, $f16, $f8
    FPMAX $f6, $f6, $f8
    LOAD $f9, $fp, 6            #: triangle
    LOAD $f10, $fp, 7           #: triangle
    LOAD $f11, $fp, 8           #: triangle
    mul.s $f17, $f25, $f12
    sub.s $f16, $f16, $f14
    sub.s $f6, $f6, $f14
    FPMAX $f8, $f9, $f10
    mul.s $f4, $f25, $f3
    mul.s $f3, $f22, $f3
    FPMAX $f8, $f8, $f11
    FPMAX $f4, $f17, $f4
    sub.s $f8, $f8, $f15
    mul.s $f7, $f26, $f6
    mul.s $f5, $f26, $f16
    mul.s $f6, $f21, $f6
    FPMAX $f5, $f5, $f7
    FPMIN $f7, $f9, $f10
    FPMIN $f4, $f4, $f5
    FPMIN $f7, $f7, $f11
    mul.s $f9, $f24, $f8
    sub.s $f7, $f7, $f15
    mul.s $f5, $f24, $f7
    FPMAX $f5, $f5, $f9
    FPMIN $f4, $f4, $f5
    mul.s $f9, $f22, $f12
    FPMIN $f3, $f9, $f3
    mul.s $f5, $f21, $f16
    FPMIN $f5, $f5, $f6
    FPMAX $f3, $f3, $f5
    mul.s $f6, $f23, $f8
    mul.s $f5, $f23, $f7
    FPMIN $f5, $f5, $f6
    mul.s $f1, $f2, $f1
    FPMAX $f5, $f3, $f5
    c.ule.s $f5, $f4
    FPMAX $f1, $f1, $f5
    FPMIN $f3, $f1, $f4
    bc1f $BB0_15                #: box_empty
    nop
    lwc1 $f1, 76($sp)
    c.olt.s $f3, $f1
    bc1t $BB0_15                #: behind
    nop
    c.ule.s $f3, $f20
    bc1f $BB0_15                #: farther
    nop
    mul.s $f0, $f0, $f2
    mov.s $f20, $f3
    andi $1, $24, 1
    move $25, $fp
    swc1 $f0, 72($sp)
    swc1 $f0, 136($sp)
    mul.s $f0, $f31, $f2
    swc1 $f0, 68($sp)
    bnez $1, $BB0_15            #: !any
    swc1 $f0, 132($sp)
    j $BB0_34
    nop
$BB0_26:
    lwc1 $f30, 84($sp)
$BB0_27:                        #: pop
    addiu $22, $22, 1
    beq $22, $9, $BB0_30        #: empty
    nop
    lwc1 $f0, -8($23)
    addiu $3, $23, -12
    c.ule.s $f0, $f20
    bc1f $BB0_27                #: beyond
    move $23, $3
    lw $ra, 0($3)
    j $BB0_8
    negu $fp, $22
$BB0_30:
    andi $1, $24, 1
    beqz $1, $BB0_39            #: any
    nop
    bltz $25, $BB0_42           #: nothing
    nop
    LOAD $f1, $25, 0            #: hit
    LOAD $f0, $25, 1            #: hit
    LOAD $f5, $25, 2            #: hit
    mfc1 $3, $f0
    sub.s $f4, $f0, $f1
    lwc1 $f20, 64($sp)
    lwc1 $f19, 68($sp)
    lwc1 $f2, %gp_rel($CPI0_5)($gp)
    sub.s $f6, $f5, $f1
    lui $5, 32768
    LOAD $f0, $25, 3            #: hit
    LOAD $f7, $25, 4            #: hit
    sub.s $f8, $f7, $f0
    LOAD $f9, $25, 5            #: hit
    lwc1 $f18, 72($sp)
    LOAD $f14, $25, 6           #: hit
    LOAD $f15, $25, 7           #: hit
    LOAD $f16, $25, 8           #: hit
    sub.s $f11, $f9, $f0
    sub.s $f17, $f16, $f14
    mfc1 $6, $f0
    mul.s $f20, $f20, $f2
    and $3, $3, $8
    mfc1 $1, $f9
    lwc1 $f9, 52($sp)
    mtc1 $3, $f12
    mfc1 $3, $f1
    and $6, $6, $8
    mul.s $f2, $f4, $f19
    mul.s $f3, $f6, $f18
    and $7, $1, $8
    mfc1 $1, $f7
    mul.s $f13, $f8, $f19
    and $3, $3, $8
    and $1, $1, $8
    swc1 $f20, 100($sp)
    mtc1 $1, $f7
    add.s $f10, $f1, $f2
    mul.s $f2, $f11, $f18
    mtc1 $6, $f1
    add.s $f13, $f0, $f13
    mul.s $f0, $f17, $f18
    sub.s $f18, $f15, $f14
    FPMAX $f1, $f1, $f7
    mtc1 $7, $f7
    lui $7, 32768
    FPMAX $f1, $f1, $f7
    add.s $f3, $f10, $f3
    lwc1 $f10, %gp_rel($CPI0_6)($gp)
    mul.s $f19, $f18, $f19
    add.s $f2, $f13, $f2
    mul.s $f13, $f6, $f8
    mul.s $f6, $f6, $f18
    mul.s $f8, $f8, $f17
    add.s $f19, $f14, $f19
    add.s $f0, $f19, $f0
    mul.s $f19, $f4, $f11
    mul.s $f4, $f4, $f17
    sub.s $f4, $f6, $f4
    mul.s $f6, $f11, $f18
    sub.s $f13, $f19, $f13
    mtc1 $3, $f19
    mfc1 $3, $f5
    lwc1 $f5, 56($sp)
    and $3, $3, $8
    sub.s $f6, $f8, $f6
    lwc1 $f8, 60($sp)
    mul.s $f5, $f5, $f4
    mul.s $f9, $f9, $f13
    mul.s $f8, $f8, $f6
    add.s $f5, $f8, $f5
    FPMAX $f8, $f19, $f12
    add.s $f5, $f9, $f5
    mfc1 $6, $f5
    mfc1 $1, $f14
    mul.s $f5, $f13, $f13
    and $1, $1, $8
    mtc1 $1, $f7
    mfc1 $1, $f15
    and $1, $1, $8
    mtc1 $1, $f9
    FPMAX $f7, $f7, $f9
    mfc1 $1, $f16
    mtc1 $3, $f9
    and $3, $6, $7
    and $1, $1, $8
    mtc1 $1, $f11
    FPMAX $f7, $f7, $f11
    FPMAX $f1, $f1, $f7
    FPMAX $f7, $f8, $f9
    mul.s $f8, $f4, $f4
    mul.s $f9, $f6, $f6
    add.s $f8, $f9, $f8
    add.s $f5, $f5, $f8
    FPINVSQRT $f5, $f5
    mfc1 $6, $f5
    xor $1, $6, $3
    xor $3, $1, $7
    FPMAX $f1, $f7, $f1
    mtc1 $3, $f5
    mul.s $f8, $f13, $f5
    mul.s $f7, $f4, $f5
    mul.s $f5, $f6, $f5
    mul.s $f1, $f1, $f10
    swc1 $f8, 148($sp)
    swc1 $f7, 144($sp)
    mul.s $f4, $f5, $f1
    swc1 $f5, 140($sp)
    add.s $f13, $f4, $f3
    mul.s $f4, $f7, $f1
    mul.s $f1, $f8, $f1
    LOAD $f3, $2, 28            #: parameters
    swc1 $f5, 40($sp)
    add.s $f14, $f4, $f2
    sub.s $f6, $f3, $f13
    LOAD $f2, $2, 29            #: parameters
    add.s $f15, $f1, $f0
    swc1 $f7, 44($sp)
    LOAD $f0, $2, 30            #: parameters
    lwc1 $f1, 76($sp)
    sub.s $f9, $f2, $f14
    sub.s $f4, $f0, $f15
    mul.s $f3, $f5, $f6
    mul.s $f2, $f7, $f9
    mul.s $f0, $f8, $f4
    add.s $f2, $f3, $f2
    add.s $f0, $f2, $f0
    c.ule.s $f0, $f1
    bc1t $BB0_35                #: !lit
    nop
    lwc1 $f1, %gp_rel($CPI0_7)($gp)
    mul.s $f2, $f6, $f6
    swc1 $f20, 64($sp)
    addiu $24, $zero, 0
    mul.s $f1, $f20, $f1
    lwc1 $f20, %gp_rel($CPI0_1)($gp)
    mul.s $f0, $f1, $f0
    mul.s $f1, $f9, $f9
    add.s $f1, $f2, $f1
    mul.s $f2, $f4, $f4
    add.s $f1, $f1, $f2
    FPINVSQRT $f1, $f1
    mul.s $f0, $f0, $f1
    mul.s $f0, $f1, $f0
    mul.s $f0, $f1, $f0
    swc1 $f0, 36($sp)
    j $BB0_6
    swc1 $f0, 128($sp)
$BB0_34:
    lwc1 $f30, 84($sp)
    lwc1 $f20, 64($sp)
    bltz $fp, $BB0_40           #: nothing
    move $25, $fp
$BB0_35:
    lw $6, 32($sp)
    bnez $6, $BB0_41            #: !last_bounce
    nop
    j $BB0_2
    nop
$BB0_37:
    lwc1 $f20, 64($sp)
    andi $1, $24, 1
    beqz $1, $BB0_40            #: any
    nop
    j $BB0_43
    nop
$BB0_39:
    lwc1 $f20, 64($sp)
    bgez $25, $BB0_35           #: !nothing
    nop
$BB0_40:
    LOAD $f0, $2, 31            #: parameters
    lwc1 $f1, 36($sp)
    lwc1 $f2, 16($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 16($sp)
    swc1 $f2, 88($sp)
    LOAD $f0, $2, 32            #: parameters
    lwc1 $f2, 20($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 20($sp)
    swc1 $f2, 92($sp)
    LOAD $f0, $2, 33            #: parameters
    mul.s $f0, $f1, $f0
    lwc1 $f1, 24($sp)
    add.s $f1, $f1, $f0
    swc1 $f1, 24($sp)
    swc1 $f1, 96($sp)
    lw $6, 32($sp)
    beqz $6, $BB0_2             #: last_bounce
    nop
$BB0_41:
    swc1 $f20, 64($sp)
    RAND $f0
    sub.s $f1, $f30, $f0
    RAND $f2
    lwc1 $f3, 148($sp)
    mfc1 $3, $f3
    lwc1 $f7, %gp_rel($CPI0_9)($gp)
    lwc1 $f10, 44($sp)
    lwc1 $f11, 40($sp)
    addiu $6, $6, -1
    and $1, $3, $5
    lui $3, 16256
    sw $6, 32($sp)
    or $3, $1, $3
    FPINVSQRT $f4, $f1
    FPINVSQRT $f5, $f0
    mul.s $f0, $f0, $f5
    mul.s $f6, $f10, $f10
    lwc1 $f5, %gp_rel($CPI0_8)($gp)
    mul.s $f1, $f1, $f4
    mtc1 $3, $f4
    add.s $f8, $f3, $f4
    mul.s $f2, $f2, $f5
    SIN $f5, $f2
    COS $f2, $f2
    mul.s $f5, $f5, $f0
    mul.s $f0, $f2, $f0
    mul.s $f2, $f11, $f10
    div.s $f7, $f7, $f8
    mul.s $f3, $f1, $f3
    mul.s $f8, $f11, $f1
    mul.s $f1, $f1, $f10
    mul.s $f6, $f6, $f7
    mul.s $f2, $f2, $f7
    mul.s $f9, $f4, $f2
    add.s $f6, $f4, $f6
    mul.s $f4, $f11, $f4
    mul.s $f2, $f5, $f2
    mul.s $f6, $f5, $f6
    mul.s $f9, $f0, $f9
    add.s $f6, $f9, $f6
    mul.s $f9, $f11, $f4
    mul.s $f7, $f9, $f7
    add.s $f9, $f1, $f6
    add.s $f7, $f7, $f30
    mul.s $f7, $f0, $f7
    mul.s $f0, $f0, $f4
    add.s $f1, $f2, $f7
    sub.s $f0, $f3, $f0
    add.s $f6, $f8, $f1
    mul.s $f1, $f5, $f10
    j $BB0_5
    sub.s $f4, $f0, $f1
$BB0_42:
    lwc1 $f20, 64($sp)
$BB0_43:
    LOAD $f0, $2, 34            #: parameters
    lwc1 $f3, 16($sp)
    mul.s $f0, $f20, $f0
    add.s $f3, $f3, $f0
    swc1 $f3, 88($sp)
    LOAD $f0, $2, 35            #: parameters
    lwc1 $f2, 20($sp)
    mul.s $f0, $f20, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 92($sp)
    LOAD $f0, $2, 36            #: parameters
    lwc1 $f1, 24($sp)
    mul.s $f0, $f20, $f0
    add.s $f1, $f1, $f0
    j $BB0_3
    swc1 $f1, 96($sp)
$BB0_44:
    lw $16, 2488($sp)
    lw $17, 2492($sp)
    lw $18, 2496($sp)
    lw $19, 2500($sp)
    lw $20, 2504($sp)
    lw $21, 2508($sp)
    lw $22, 2512($sp)
    lw $23, 2516($sp)
    lw $fp, 2520($sp)
    lw $ra, 2524($sp)
    ldc1 $f20, 2528($sp)
    ldc1 $f22, 2536($sp)
    ldc1 $f24, 2544($sp)
    ldc1 $f26, 2552($sp)
    ldc1 $f28, 2560($sp)
    ldc1 $f30, 2568($sp)
    addiu $2, $zero, 0
    jr $ra
    addiu $sp, $sp, 2576
