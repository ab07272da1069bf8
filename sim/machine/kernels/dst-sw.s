main:                           #: start
    addiu $sp, $sp, -2560
    sdc1 $f30, 2552($sp)
    sdc1 $f28, 2544($sp)
    sdc1 $f26, 2536($sp)
    sdc1 $f24, 2528($sp)
    sdc1 $f22, 2520($sp)
    sdc1 $f20, 2512($sp)
    sw $ra, 2508($sp)
    sw $fp, 2504($sp)
    sw $23, 2500($sp)
    sw $22, 2496($sp)
    sw $21, 2492($sp)
    sw $20, 2488($sp)
    sw $19, 2484($sp)
    sw $18, 2480($sp)
    sw $17, 2476($sp)
    sw $16, 2472($sp)
    addiu $ra, $zero, 0
    LOAD $2, $ra, 1             #: parameters
    LOAD $4, $ra, 8             #: parameters
    LOAD $3, $ra, 9             #: parameters
    sw $3, 32($sp)
    ATOMIC_INC $3, 0
    slt $1, $3, $2
    beqz $1, $BB0_67            #: no_more
    sw $2, 4($sp)
    lwc1 $f0, %gp_rel($CPI0_0)($gp)
    lui $1, 32767
    addiu $9, $zero, 1
    lui $13, 1024
    lui $24, 2048
    ori $8, $1, 65535
    lui $1, 1023
    swc1 $f0, 0($sp)
    lwc1 $f0, %gp_rel($CPI0_1)($gp)
    swc1 $f0, 68($sp)
    lwc1 $f0, %gp_rel($CPI0_2)($gp)
    swc1 $f0, 12($sp)
    j $BB0_4
    ori $12, $1, 65535
$BB0_2:
    lwc1 $f4, 80($sp)
    lwc1 $f6, 76($sp)
    lwc1 $f5, 72($sp)
$BB0_3:
    lw $2, 8($sp)
    sll $1, $2, 1
    addu $2, $1, $2
    LOAD $3, $ra, 7             #: parameters
    addu $2, $3, $2
    STORE $f5, $2, 0            #: pixel
    STORE $f6, $2, 1            #: pixel
    STORE $f4, $2, 2            #: pixel
    ATOMIC_INC $3, 0
    lw $1, 4($sp)
    slt $1, $3, $1
    beqz $1, $BB0_67            #: no_more
    nop
$BB0_4:
    mtc1 $3, $f0
    sw $3, 8($sp)
    LOAD $f4, $ra, 3            #: parameters
    cvt.s.w $f0, $f0
    mul.s $f4, $f4, $f0
    trunc.w.s $f4, $f4
    mfc1 $1, $f4
    mtc1 $1, $f4
    LOAD $f5, $ra, 4            #: parameters
    LOAD $f6, $ra, 19           #: parameters
    LOAD $f7, $ra, 22           #: parameters
    lwc1 $f1, 0($sp)
    LOAD $f9, $ra, 25           #: parameters
    LOAD $f10, $ra, 20          #: parameters
    LOAD $f11, $ra, 23          #: parameters
    LOAD $f12, $ra, 26          #: parameters
    cvt.s.w $f4, $f4
    add.s $f8, $f4, $f1
    mul.s $f4, $f5, $f4
    sub.s $f0, $f0, $f4
    mul.s $f12, $f8, $f12
    mul.s $f9, $f8, $f9
    add.s $f0, $f0, $f1
    mul.s $f4, $f0, $f11
    mul.s $f7, $f7, $f0
    add.s $f4, $f10, $f4
    add.s $f6, $f6, $f7
    LOAD $f7, $ra, 21           #: parameters
    add.s $f11, $f9, $f6
    add.s $f4, $f4, $f12
    mul.s $f5, $f4, $f4
    mul.s $f6, $f11, $f11
    add.s $f5, $f6, $f5
    LOAD $f6, $ra, 24           #: parameters
    mul.s $f0, $f0, $f6
    LOAD $f9, $ra, 27           #: parameters
    mul.s $f8, $f8, $f9
    LOAD $f1, $ra, 16           #: parameters
    swc1 $f1, 64($sp)
    add.s $f0, $f7, $f0
    add.s $f0, $f0, $f8
    mul.s $f6, $f0, $f0
    add.s $f8, $f5, $f6
    LOAD $f6, $ra, 17           #: parameters
    LOAD $f7, $ra, 18           #: parameters
    lui $1, 16256
    sw $1, 84($sp)
    FPINVSQRT $f8, $f8
    mul.s $f3, $f8, $f0
    mul.s $f10, $f4, $f8
    mul.s $f5, $f11, $f8
    sw $zero, 80($sp)
    sw $zero, 76($sp)
    sw $zero, 72($sp)
    LOAD $2, $ra, 2             #: parameters
    lwc1 $f0, 68($sp)
    sw $2, 16($sp)
    swc1 $f0, 48($sp)
$BB0_5:
    lwc1 $f22, 12($sp)
    addiu $17, $zero, 1
$BB0_6:                         #: ray
    mfc1 $1, $f3
    mfc1 $3, $f10
    addiu $2, $zero, 2
    addiu $18, $sp, 72
    swc1 $f5, 44($sp)
    swc1 $f10, 40($sp)
    swc1 $f3, 36($sp)
    and $1, $1, $8
    and $3, $3, $8
    mtc1 $1, $f0
    mfc1 $1, $f5
    mtc1 $3, $f12
    addiu $3, $zero, 1
    and $1, $1, $8
    mtc1 $1, $f11
    addiu $1, $zero, 1
    c.ule.s $f11, $f0
    movt $1, $zero, $fcc0
    c.ule.s $f11, $f12
    movt $3, $zero, $fcc0
    c.ule.s $f12, $f0
    lwc1 $f0, 68($sp)
    div.s $f12, $f0, $f10
    div.s $f13, $f0, $f5
    div.s $f14, $f0, $f3
    and $1, $3, $1
    addiu $3, $zero, 2
    movf $3, $9, $fcc0
    addiu $5, $3, -1
    movn $3, $zero, $1
    movn $5, $2, $1
    mfc1 $10, $f12
    mfc1 $11, $f13
    addiu $6, $3, 1
    xori $7, $3, 2
    mfc1 $14, $f14
    movz $6, $zero, $7
    addiu $11, $11, 4
    addiu $10, $10, 4
    mtc1 $10, $f15
    mtc1 $11, $f16
    sll $7, $3, 1
    sll $15, $5, 1
    addiu $14, $14, 4
    sll $1, $6, 2
    addu $19, $7, $3
    sll $10, $5, 2
    sll $3, $3, 2
    addu $21, $15, $5
    addu $7, $1, $18
    sll $1, $6, 1
    addu $10, $10, $18
    addu $3, $3, $18
    addu $20, $1, $6
    mtc1 $14, $f17
    addiu $2, $7, 16
    addiu $5, $10, 16
    addiu $22, $10, 28
    addiu $23, $7, 28
    addiu $1, $3, 28
    addiu $3, $3, 16
    sw $2, 28($sp)
    sw $5, 24($sp)
    sw $1, 52($sp)
    sw $3, 20($sp)
$BB0_7:
    lwc1 $f1, 64($sp)
    swc1 $f17, 156($sp)
    swc1 $f15, 152($sp)
    swc1 $f16, 148($sp)
    swc1 $f14, 144($sp)
    swc1 $f12, 140($sp)
    swc1 $f13, 136($sp)
    swc1 $f7, 108($sp)
    swc1 $f6, 104($sp)
    mtc1 $zero, $f11
    swc1 $f1, 100($sp)
    swc1 $f3, 96($sp)
    swc1 $f10, 92($sp)
    swc1 $f5, 88($sp)
    lwc1 $f18, 0($3)
    lwc1 $f20, 0($2)
    lwc1 $f19, 0($5)
    LOAD $f0, $ra, 40           #: parameters
    LOAD $f21, $ra, 41          #: parameters
    LOAD $f23, $ra, 42          #: parameters
    LOAD $f25, $ra, 43          #: parameters
    LOAD $f27, $ra, 44          #: parameters
    LOAD $f28, $ra, 45          #: parameters
    sub.s $f0, $f0, $f1
    sub.s $f25, $f25, $f1
    sub.s $f21, $f21, $f6
    sub.s $f27, $f27, $f6
    sub.s $f23, $f23, $f7
    sub.s $f28, $f28, $f7
    mul.s $f24, $f16, $f0
    mul.s $f26, $f16, $f25
    mul.s $f0, $f13, $f0
    mul.s $f25, $f13, $f25
    mul.s $f29, $f15, $f27
    FPMAX $f24, $f24, $f26
    mul.s $f26, $f15, $f21
    mul.s $f21, $f12, $f21
    FPMIN $f0, $f0, $f25
    mul.s $f25, $f12, $f27
    FPMAX $f26, $f26, $f29
    FPMIN $f21, $f21, $f25
    FPMIN $f24, $f24, $f26
    FPMAX $f0, $f0, $f21
    mul.s $f29, $f17, $f28
    mul.s $f26, $f17, $f23
    mul.s $f21, $f14, $f23
    mul.s $f23, $f14, $f28
    FPMAX $f26, $f26, $f29
    FPMIN $f21, $f21, $f23
    FPMIN $f26, $f26, $f22
    FPMAX $f21, $f21, $f11
    FPMIN $f24, $f24, $f26
    FPMAX $f23, $f0, $f21
    c.ule.s $f23, $f24
    bc1f $BB0_60                #: root_missed
    nop
    lwc1 $f0, 68($sp)
    mov.s $f21, $f22
    mov.s $f22, $f24
    addiu $6, $zero, -1
    addiu $fp, $zero, 0
    addiu $14, $zero, 0
    div.s $f0, $f0, $f18
    mul.s $f19, $f0, $f19
    mul.s $f20, $f20, $f0
    swc1 $f0, 60($sp)
$BB0_9:
    move $10, $25
    move $16, $fp
$BB0_10:
    sll $1, $14, 2
    sll $3, $14, 3
    addiu $fp, $sp, 168
    negu $15, $14
    addu $1, $3, $1
    addu $11, $fp, $1
$BB0_11:                        #: node
    mov.s $f24, $f22
    addu $3, $16, $4
    LOAD $5, $3, 0              #: node
    bltz $5, $BB0_21            #: carve
    and $25, $5, $12
    and $1, $5, $13
    bnez $1, $BB0_35            #: bare_leaf
    nop
    srl $1, $5, 27
    andi $2, $1, 28
    andi $1, $1, 3
    addu $2, $2, $18
    addu $16, $1, $25
    LOAD $f25, $3, 1            #: node
    LOAD $f27, $3, 2            #: node
    lwc1 $f28, 28($2)
    lwc1 $f0, 64($2)
    lwc1 $f22, 76($2)
    sub.s $f26, $f25, $f28
    c.olt.s $f0, $f11
    bc1f $BB0_16                #: !swap
    sub.s $f27, $f27, $f28
    mul.s $f0, $f26, $f0
    FPMAX $f25, $f23, $f0
    move $3, $25
    mul.s $f0, $f27, $f22
    FPMIN $f22, $f24, $f0
    c.ole.s $f23, $f22
    bc1t $BB0_17                #: near
    nop
    j $BB0_19
    nop
$BB0_16:
    mul.s $f0, $f27, $f0
    move $3, $16
    move $16, $25
    FPMAX $f25, $f23, $f0
    mul.s $f0, $f26, $f22
    FPMIN $f22, $f24, $f0
    c.ole.s $f23, $f22
    bc1f $BB0_19                #: !near
    nop
$BB0_17:
    c.ole.s $f25, $f24
    bc1f $BB0_11                #: !far
    nop
    sll $1, $14, 2
    sll $2, $14, 3
    addiu $11, $11, 12
    addiu $15, $15, -1
    addiu $14, $14, 1
    addu $1, $2, $1
    addu $1, $fp, $1
    swc1 $f24, 8($1)
    swc1 $f25, 4($1)
    j $BB0_11
    sw $3, 0($1)
$BB0_19:
    mov.s $f23, $f25
    mov.s $f22, $f24
    c.ole.s $f25, $f24
    bc1t $BB0_10                #: far
    move $16, $3
    j $BB0_48
    move $25, $10
$BB0_21:
    LOAD $f25, $3, 1            #: node
    LOAD $f22, $3, 2            #: node
    srl $fp, $5, 27
    srl $3, $5, 29
    andi $ra, $3, 3
    addiu $1, $zero, 2
    bne $ra, $1, $BB0_24        #: !single
    andi $7, $fp, 3
    sll $1, $7, 2
    addu $1, $1, $18
    lwc1 $f27, 28($1)
    lwc1 $f0, 64($1)
    lwc1 $f26, 76($1)
    sub.s $f25, $f25, $f27
    c.olt.s $f0, $f11
    bc1f $BB0_26                #: !swap
    sub.s $f22, $f22, $f27
    mul.s $f0, $f25, $f0
    FPMAX $f23, $f23, $f0
    addiu $ra, $zero, 0
    mul.s $f0, $f22, $f26
    FPMIN $f22, $f24, $f0
    j $BB0_31
    nop
$BB0_24:
    srl $1, $ra, 1
    sll $1, $1, 2
    addu $ra, $1, $18
    lwc1 $f26, 28($ra)
    lwc1 $f0, 64($ra)
    mfc1 $2, $f0
    srl $1, $2, 31
    srl $2, $7, 1
    bne $1, $2, $BB0_27         #: entry0
    sub.s $f25, $f25, $f26
    lwc1 $f0, 76($ra)
    addiu $ra, $zero, 0
    mul.s $f0, $f25, $f0
    FPMIN $f24, $f24, $f0
    j $BB0_28
    nop
$BB0_26:
    mul.s $f0, $f22, $f0
    FPMAX $f23, $f23, $f0
    addiu $ra, $zero, 0
    mul.s $f0, $f25, $f26
    FPMIN $f22, $f24, $f0
    j $BB0_31
    nop
$BB0_27:
    addiu $ra, $zero, 0
    mul.s $f0, $f0, $f25
    FPMAX $f23, $f23, $f0
$BB0_28:
    andi $1, $3, 1
    andi $2, $fp, 1
    sll $1, $1, 2
    addu $3, $18, $1
    lwc1 $f0, 32($3)
    sub.s $f0, $f22, $f0
    lwc1 $f22, 68($3)
    mfc1 $7, $f22
    srl $1, $7, 31
    bne $1, $2, $BB0_30         #: entry1
    nop
    lwc1 $f22, 80($3)
    mul.s $f0, $f0, $f22
    FPMIN $f22, $f24, $f0
    j $BB0_31
    nop
$BB0_30:
    mul.s $f0, $f22, $f0
    mov.s $f22, $f24
    FPMAX $f23, $f23, $f0
$BB0_31:
    c.ule.s $f23, $f22
    and $1, $5, $13
    move $fp, $25
    movz $25, $10, $1
    srl $1, $1, 23
    movf $fp, $16, $fcc0
    movf $25, $10, $fcc0
    c.ule.s $f23, $f22
    xori $3, $1, 8
    addiu $1, $zero, 10
    movf $3, $1, $fcc0
    addiu $1, $zero, 8
    beq $3, $1, $BB0_9          #: carve_on
    nop
$BB0_32:
    beqz $3, $BB0_35            #: carve_leaf
    nop
$BB0_33:
    addiu $1, $zero, 10
    beq $3, $1, $BB0_48         #: always
    nop
$BB0_34:
    j $BB0_51
    nop
$BB0_35:
    sll $1, $25, 1
    sll $2, $25, 3
    addu $1, $2, $1
    lw $2, 32($sp)
    addu $25, $1, $2
    lw $1, 52($sp)
    lwc1 $f22, 0($1)
    j $BB0_37
    nop
$BB0_36:
    and $1, $10, $24
    bnez $1, $BB0_47            #: last
    addiu $25, $25, 10
$BB0_37:                        #: triangle
    addu $2, $20, $25
    lwc1 $f0, 0($22)
    lwc1 $f23, 0($23)
    LOAD $f24, $2, 0            #: row0
    LOAD $f25, $2, 1            #: row0
    LOAD $f26, $2, 2            #: row0
    lwc1 $f29, %gp_rel($CPI0_3)($gp)
    addu $2, $21, $25
    LOAD $f28, $2, 0            #: row1
    LOAD $f27, $2, 1            #: row1
    LOAD $f2, $2, 2             #: row1
    addu $2, $19, $25
    sub.s $f9, $f27, $f0
    LOAD $f4, $2, 0             #: row2
    sub.s $f27, $f4, $f22
    sub.s $f31, $f26, $f23
    sub.s $f8, $f25, $f23
    LOAD $f26, $2, 1            #: row2
    sub.s $f25, $f26, $f22
    sub.s $f23, $f24, $f23
    LOAD $f30, $2, 2            #: row2
    sub.s $f26, $f30, $f22
    lwc1 $f30, %gp_rel($CPI0_4)($gp)
    mul.s $f4, $f20, $f27
    mul.s $f24, $f20, $f25
    mul.s $f18, $f19, $f25
    mfc1 $1, $f23
    mfc1 $7, $f8
    mfc1 $3, $f9
    mfc1 $2, $f31
    and $14, $1, $8
    and $3, $3, $8
    and $2, $2, $8
    mtc1 $3, $f10
    sub.s $f4, $f23, $f4
    sub.s $f24, $f8, $f24
    sub.s $f8, $f28, $f0
    sub.s $f0, $f2, $f0
    mul.s $f2, $f19, $f27
    sub.s $f9, $f9, $f18
    mul.s $f23, $f20, $f26
    mfc1 $1, $f4
    mfc1 $5, $f24
    mfc1 $10, $f8
    sub.s $f2, $f8, $f2
    mfc1 $3, $f0
    and $1, $1, $8
    and $10, $10, $8
    mtc1 $1, $f8
    and $1, $5, $8
    mtc1 $10, $f28
    and $5, $7, $8
    mtc1 $1, $f1
    mfc1 $1, $f9
    mfc1 $16, $f2
    and $1, $1, $8
    and $16, $16, $8
    mtc1 $1, $f18
    FPMAX $f1, $f8, $f1
    FPMAX $f8, $f28, $f10
    mul.s $f28, $f19, $f26
    mtc1 $16, $f3
    LOAD $10, $25, 9            #: triangle
    mtc1 $14, $f10
    FPMAX $f3, $f3, $f18
    sub.s $f18, $f31, $f23
    sub.s $f0, $f0, $f28
    mul.s $f5, $f9, $f18
    mfc1 $1, $f18
    mul.s $f23, $f2, $f18
    mul.s $f2, $f2, $f24
    and $1, $1, $8
    mul.s $f28, $f24, $f0
    mfc1 $7, $f0
    mul.s $f31, $f4, $f0
    mul.s $f0, $f4, $f9
    and $7, $7, $8
    mtc1 $7, $f4
    sub.s $f28, $f5, $f28
    mtc1 $1, $f5
    and $1, $3, $8
    mfc1 $3, $f27
    sub.s $f23, $f31, $f23
    sub.s $f24, $f2, $f0
    mtc1 $1, $f9
    FPMAX $f1, $f1, $f5
    FPMAX $f3, $f3, $f4
    FPMAX $f4, $f8, $f9
    FPMIN $f18, $f28, $f23
    mtc1 $5, $f8
    mtc1 $2, $f5
    FPMAX $f9, $f28, $f23
    and $3, $3, $8
    mfc1 $1, $f25
    mtc1 $3, $f0
    and $1, $1, $8
    mtc1 $1, $f2
    FPMAX $f0, $f0, $f2
    mfc1 $1, $f26
    and $1, $1, $8
    mtc1 $1, $f2
    FPMAX $f0, $f0, $f2
    FPMAX $f1, $f1, $f3
    FPMAX $f31, $f9, $f24
    FPMAX $f2, $f10, $f8
    FPMAX $f0, $f4, $f0
    FPMAX $f2, $f2, $f5
    FPMAX $f0, $f2, $f0
    mul.s $f2, $f0, $f30
    mul.s $f0, $f0, $f29
    FPMIN $f30, $f18, $f24
    add.s $f1, $f2, $f1
    mul.s $f0, $f0, $f1
    c.ule.s $f31, $f0
    bc1t $BB0_39                #: negative
    neg.s $f29, $f0
    c.olt.s $f30, $f29
    bc1t $BB0_36                #: outside
    nop
$BB0_39:
    c.ole.s $f30, $f0
    bc1f $BB0_42                #: positive
    nop
    c.ult.s $f31, $f29
    bc1t $BB0_42                #: !exact
    nop
    EXACT $f28, $f23, $f24, $f27
$BB0_42:
    mul.s $f0, $f28, $f27
    mul.s $f1, $f25, $f23
    mul.s $f2, $f26, $f24
    add.s $f0, $f1, $f0
    add.s $f1, $f23, $f28
    add.s $f0, $f2, $f0
    LOAD $f2, $25, 0            #: triangle
    LOAD $f3, $25, 1            #: triangle
    LOAD $f4, $25, 2            #: triangle
    LOAD $f5, $25, 3            #: triangle
    LOAD $f8, $25, 4            #: triangle
    lwc1 $f9, 60($sp)
    add.s $f1, $f24, $f1
    FPMIN $f27, $f5, $f8
    FPMIN $f26, $f2, $f3
    FPMAX $f5, $f5, $f8
    FPMAX $f2, $f2, $f3
    FPMIN $f26, $f26, $f4
    FPMAX $f2, $f2, $f4
    mul.s $f0, $f9, $f0
    lwc1 $f9, 68($sp)
    div.s $f25, $f9, $f1
    LOAD $f1, $25, 5            #: triangle
    FPMIN $f27, $f27, $f1
    LOAD $f9, $25, 6            #: triangle
    LOAD $f10, $25, 7           #: triangle
    LOAD $f18, $25, 8           #: triangle
    lwc1 $f29, 64($sp)
    FPMAX $f8, $f9, $f10
    FPMAX $f1, $f5, $f1
    sub.s $f27, $f27, $f6
    FPMAX $f8, $f8, $f18
    sub.s $f1, $f1, $f6
    sub.s $f2, $f2, $f29
    sub.s $f26, $f26, $f29
    sub.s $f8, $f8, $f7
    mul.s $f4, $f15, $f27
    mul.s $f5, $f15, $f1
    FPMAX $f4, $f4, $f5
    mul.s $f3, $f16, $f2
    mul.s $f28, $f16, $f26
    mul.s $f2, $f13, $f2
    mul.s $f1, $f12, $f1
    FPMIN $f5, $f9, $f10
    FPMAX $f3, $f28, $f3
    mul.s $f9, $f17, $f8
    FPMIN $f5, $f5, $f18
    FPMIN $f3, $f3, $f4
    sub.s $f5, $f5, $f7
    mul.s $f4, $f17, $f5
    FPMAX $f4, $f4, $f9
    mul.s $f9, $f13, $f26
    FPMIN $f3, $f3, $f4
    FPMIN $f2, $f9, $f2
    mul.s $f4, $f12, $f27
    FPMIN $f1, $f4, $f1
    FPMAX $f1, $f2, $f1
    mul.s $f2, $f14, $f5
    mul.s $f4, $f14, $f8
    FPMIN $f2, $f2, $f4
    FPMAX $f1, $f1, $f2
    c.ule.s $f1, $f3
    mul.s $f0, $f25, $f0
    FPMAX $f0, $f0, $f1
    FPMIN $f26, $f0, $f3
    bc1f $BB0_36                #: box_empty
    nop
    c.olt.s $f26, $f11
    bc1t $BB0_36                #: behind
    nop
    c.ule.s $f26, $f21
    bc1f $BB0_36                #: farther
    nop
    mul.s $f0, $f24, $f25
    mov.s $f21, $f26
    andi $1, $17, 1
    move $6, $25
    swc1 $f0, 120($sp)
    mul.s $f0, $f23, $f25
    swc1 $f0, 56($sp)
    bnez $1, $BB0_36            #: !any
    swc1 $f0, 116($sp)
    j $BB0_56
    nop
$BB0_47:
    addiu $25, $25, -10
$BB0_48:                        #: pop
    addiu $15, $15, 1
    beq $15, $9, $BB0_52        #: empty
    nop
    lwc1 $f23, -8($11)
    addiu $3, $11, -12
    c.ule.s $f23, $f21
    bc1f $BB0_48                #: beyond
    move $11, $3
    lw $fp, 0($3)
    lwc1 $f0, 8($3)
    negu $14, $15
    FPMIN $f22, $f0, $f21
    j $BB0_9
    nop
$BB0_51:
    lwc1 $f5, 44($sp)
    lwc1 $f10, 40($sp)
    lwc1 $f3, 36($sp)
    lw $2, 28($sp)
    lw $5, 24($sp)
    lw $3, 20($sp)
    j $BB0_7
    nop
$BB0_52:
    andi $1, $17, 1
    beqz $1, $BB0_57            #: any
    nop
    bltz $6, $BB0_65            #: nothing
    nop
    LOAD $f0, $6, 0             #: hit
    LOAD $f1, $6, 1             #: hit
    LOAD $f2, $6, 2             #: hit
    LOAD $f3, $6, 3             #: hit
    LOAD $f4, $6, 4             #: hit
    lwc1 $f22, 48($sp)
    LOAD $f8, $6, 5             #: hit
    lwc1 $f17, 56($sp)
    sub.s $f6, $f1, $f0
    LOAD $f12, $6, 6            #: hit
    LOAD $f13, $6, 7            #: hit
    mfc1 $7, $f1
    mfc1 $2, $f3
    sub.s $f20, $f8, $f3
    sub.s $f7, $f4, $f3
    sub.s $f9, $f2, $f0
    sub.s $f14, $f13, $f12
    mfc1 $3, $f2
    mfc1 $5, $f0
    lwc1 $f5, %gp_rel($CPI0_5)($gp)
    LOAD $f1, $6, 8             #: hit
    sub.s $f18, $f1, $f12
    lwc1 $f15, 120($sp)
    mfc1 $1, $f4
    and $2, $2, $8
    and $3, $3, $8
    and $5, $5, $8
    and $6, $7, $8
    mul.s $f22, $f22, $f5
    lwc1 $f5, %gp_rel($CPI0_6)($gp)
    mtc1 $2, $f19
    and $1, $1, $8
    mul.s $f2, $f7, $f17
    mul.s $f10, $f6, $f17
    mul.s $f21, $f6, $f20
    mul.s $f16, $f9, $f14
    mul.s $f17, $f14, $f17
    mul.s $f14, $f20, $f14
    mtc1 $1, $f4
    mul.s $f6, $f6, $f18
    FPMAX $f4, $f19, $f4
    mul.s $f19, $f9, $f7
    mul.s $f7, $f7, $f18
    swc1 $f22, 84($sp)
    mfc1 $1, $f8
    add.s $f0, $f0, $f10
    add.s $f2, $f3, $f2
    mtc1 $5, $f3
    lui $5, 32768
    mul.s $f10, $f20, $f15
    sub.s $f6, $f16, $f6
    lwc1 $f16, 40($sp)
    and $1, $1, $8
    sub.s $f7, $f7, $f14
    lwc1 $f14, 44($sp)
    sub.s $f19, $f21, $f19
    mtc1 $1, $f8
    FPMAX $f4, $f4, $f8
    mtc1 $6, $f21
    mul.s $f8, $f9, $f15
    lwc1 $f9, 36($sp)
    mfc1 $1, $f12
    add.s $f12, $f12, $f17
    mtc1 $3, $f17
    mul.s $f15, $f18, $f15
    add.s $f2, $f2, $f10
    mul.s $f16, $f16, $f6
    and $2, $1, $8
    mul.s $f14, $f14, $f7
    mul.s $f9, $f9, $f19
    add.s $f0, $f0, $f8
    add.s $f14, $f14, $f16
    add.s $f9, $f9, $f14
    mfc1 $3, $f9
    mul.s $f14, $f19, $f19
    mfc1 $1, $f13
    mtc1 $2, $f9
    and $2, $3, $5
    and $1, $1, $8
    mtc1 $1, $f13
    FPMAX $f9, $f9, $f13
    mfc1 $1, $f1
    mul.s $f13, $f7, $f7
    and $1, $1, $8
    mtc1 $1, $f1
    FPMAX $f3, $f3, $f21
    FPMAX $f1, $f9, $f1
    mul.s $f9, $f6, $f6
    FPMAX $f3, $f3, $f17
    FPMAX $f1, $f4, $f1
    FPMAX $f1, $f3, $f1
    add.s $f3, $f12, $f15
    mul.s $f1, $f1, $f5
    add.s $f9, $f13, $f9
    add.s $f9, $f14, $f9
    FPINVSQRT $f9, $f9
    mfc1 $3, $f9
    xor $2, $3, $2
    xor $2, $2, $5
    mtc1 $2, $f4
    mul.s $f8, $f19, $f4
    mul.s $f9, $f6, $f4
    mul.s $f4, $f7, $f4
    swc1 $f8, 132($sp)
    swc1 $f9, 128($sp)
    mul.s $f5, $f4, $f1
    swc1 $f4, 124($sp)
    add.s $f5, $f5, $f0
    LOAD $f0, $ra, 28           #: parameters
    swc1 $f5, 64($sp)
    sub.s $f5, $f0, $f5
    mul.s $f0, $f4, $f5
    mul.s $f4, $f9, $f1
    mul.s $f1, $f8, $f1
    add.s $f6, $f4, $f2
    LOAD $f2, $ra, 29           #: parameters
    add.s $f7, $f1, $f3
    LOAD $f1, $ra, 30           #: parameters
    sub.s $f10, $f2, $f6
    sub.s $f3, $f1, $f7
    mul.s $f2, $f9, $f10
    mul.s $f1, $f8, $f3
    add.s $f0, $f0, $f2
    add.s $f0, $f0, $f1
    c.ule.s $f0, $f11
    bc1t $BB0_63                #: !lit
    nop
    lwc1 $f1, %gp_rel($CPI0_7)($gp)
    mul.s $f2, $f5, $f5
    swc1 $f22, 48($sp)
    addiu $17, $zero, 0
    mul.s $f1, $f22, $f1
    lwc1 $f22, %gp_rel($CPI0_1)($gp)
    mul.s $f0, $f1, $f0
    mul.s $f1, $f10, $f10
    add.s $f1, $f2, $f1
    mul.s $f2, $f3, $f3
    add.s $f1, $f1, $f2
    FPINVSQRT $f1, $f1
    mul.s $f0, $f0, $f1
    mul.s $f0, $f1, $f0
    mul.s $f0, $f1, $f0
    j $BB0_6
    swc1 $f0, 112($sp)
$BB0_56:
    move $6, $25
$BB0_57:
    lwc1 $f22, 48($sp)
    bltz $6, $BB0_61            #: nothing
    nop
    lw $3, 16($sp)
    bnez $3, $BB0_62            #: !last_bounce
    nop
    j $BB0_2
    nop
$BB0_60:
    lwc1 $f22, 48($sp)
    andi $1, $17, 1
    bnez $1, $BB0_66            #: !any
    nop
$BB0_61:
    lwc1 $f0, 112($sp)
    LOAD $f1, $ra, 31           #: parameters
    lwc1 $f2, 72($sp)
    mul.s $f1, $f0, $f1
    add.s $f1, $f2, $f1
    swc1 $f1, 72($sp)
    LOAD $f1, $ra, 32           #: parameters
    lwc1 $f2, 76($sp)
    mul.s $f1, $f0, $f1
    add.s $f1, $f2, $f1
    swc1 $f1, 76($sp)
    LOAD $f1, $ra, 33           #: parameters
    mul.s $f0, $f0, $f1
    lw $3, 16($sp)
    lwc1 $f1, 80($sp)
    add.s $f0, $f1, $f0
    beqz $3, $BB0_2             #: last_bounce
    swc1 $f0, 80($sp)
$BB0_62:
    swc1 $f22, 48($sp)
    RAND $f0
    lwc1 $f14, 68($sp)
    RAND $f2
    lwc1 $f3, 132($sp)
    mfc1 $2, $f3
    lwc1 $f10, %gp_rel($CPI0_9)($gp)
    lwc1 $f4, %gp_rel($CPI0_8)($gp)
    addiu $3, $3, -1
    sw $3, 16($sp)
    sub.s $f1, $f14, $f0
    FPINVSQRT $f5, $f1
    mul.s $f2, $f2, $f4
    lui $1, 32768
    and $1, $2, $1
    lui $2, 16256
    or $2, $1, $2
    mtc1 $2, $f8
    add.s $f11, $f3, $f8
    FPINVSQRT $f4, $f0
    mul.s $f0, $f0, $f4
    COS $f9, $f2
    SIN $f2, $f2
    mul.s $f1, $f1, $f5
    lwc1 $f5, 124($sp)
    lwc1 $f4, 128($sp)
    div.s $f10, $f10, $f11
    mul.s $f11, $f4, $f4
    mul.s $f2, $f2, $f0
    mul.s $f0, $f9, $f0
    mul.s $f9, $f5, $f4
    mul.s $f12, $f5, $f1
    mul.s $f3, $f1, $f3
    mul.s $f1, $f1, $f4
    mul.s $f11, $f11, $f10
    mul.s $f9, $f9, $f10
    mul.s $f13, $f8, $f9
    add.s $f11, $f8, $f11
    mul.s $f8, $f5, $f8
    mul.s $f9, $f2, $f9
    mul.s $f5, $f5, $f8
    mul.s $f11, $f2, $f11
    mul.s $f13, $f0, $f13
    mul.s $f5, $f5, $f10
    add.s $f11, $f13, $f11
    add.s $f5, $f5, $f14
    add.s $f10, $f1, $f11
    mul.s $f5, $f0, $f5
    mul.s $f0, $f0, $f8
    add.s $f1, $f9, $f5
    sub.s $f0, $f3, $f0
    add.s $f5, $f12, $f1
    mul.s $f1, $f2, $f4
    j $BB0_5
    sub.s $f3, $f0, $f1
$BB0_63:
    lw $3, 16($sp)
    bnez $3, $BB0_62            #: !last_bounce
    nop
    j $BB0_2
    nop
$BB0_65:
    lwc1 $f22, 48($sp)
$BB0_66:
    LOAD $f0, $ra, 34           #: parameters
    lwc1 $f1, 72($sp)
    mul.s $f0, $f22, $f0
    add.s $f5, $f1, $f0
    swc1 $f5, 72($sp)
    LOAD $f0, $ra, 35           #: parameters
    lwc1 $f1, 76($sp)
    mul.s $f0, $f22, $f0
    add.s $f6, $f1, $f0
    swc1 $f6, 76($sp)
    LOAD $f0, $ra, 36           #: parameters
    lwc1 $f1, 80($sp)
    mul.s $f0, $f22, $f0
    add.s $f4, $f1, $f0
    j $BB0_3
    swc1 $f4, 80($sp)
$BB0_67:
    lw $16, 2472($sp)
    lw $17, 2476($sp)
    lw $18, 2480($sp)
    lw $19, 2484($sp)
    lw $20, 2488($sp)
    lw $21, 2492($sp)
    lw $22, 2496($sp)
    lw $23, 2500($sp)
    lw $fp, 2504($sp)
    lw $ra, 2508($sp)
    ldc1 $f20, 2512($sp)
    ldc1 $f22, 2520($sp)
    ldc1 $f24, 2528($sp)
    ldc1 $f26, 2536($sp)
    ldc1 $f28, 2544($sp)
    ldc1 $f30, 2552($sp)
    addiu $2, $zero, 0
    jr $ra
    addiu $sp, $sp, 2560
