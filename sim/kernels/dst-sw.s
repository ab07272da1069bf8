main:                           #: start
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
    addiu $20, $zero, 0
    LOAD $2, $20, 1             #: parameters
    LOAD $4, $20, 8             #: parameters
    LOAD $3, $20, 9             #: parameters
    sw $3, 60($sp)
    ATOMIC_INC $3, 0
    slt $1, $3, $2
    beqz $1, $BB0_65            #: no_more
    sw $2, 12($sp)
    lwc1 $f0, %gp_rel($CPI0_0)($gp)
    lui $1, 32767
    addiu $9, $zero, 1
    lui $13, 1024
    lui $16, 2048
    lui $17, 57344
    lui $18, 8192
    ori $8, $1, 65535
    lui $1, 1023
    swc1 $f0, 8($sp)
    lwc1 $f0, %gp_rel($CPI0_1)($gp)
    swc1 $f0, 96($sp)
    mtc1 $zero, $f0
    swc1 $f0, 4($sp)
    lwc1 $f0, %gp_rel($CPI0_2)($gp)
    swc1 $f0, 32($sp)
    j $BB0_4
    ori $12, $1, 65535
$BB0_2:
    lwc1 $f1, 28($sp)
    lwc1 $f2, 24($sp)
    lwc1 $f3, 20($sp)
$BB0_3:
    lw $2, 16($sp)
    sll $1, $2, 1
    addu $2, $1, $2
    LOAD $3, $20, 7             #: parameters
    addu $2, $3, $2
    STORE $f3, $2, 0            #: pixel
    STORE $f2, $2, 1            #: pixel
    STORE $f1, $2, 2            #: pixel
    ATOMIC_INC $3, 0
    lw $1, 12($sp)
    slt $1, $3, $1
    beqz $1, $BB0_65            #: no_more
    nop
$BB0_4:
    mtc1 $3, $f0
    sw $3, 16($sp)
    LOAD $f2, $20, 3            #: parameters
    cvt.s.w $f0, $f0
    mul.s $f2, $f2, $f0
    trunc.w.s $f2, $f2
    mfc1 $1, $f2
    mtc1 $1, $f2
    LOAD $f3, $20, 4            #: parameters
    LOAD $f6, $20, 19           #: parameters
    LOAD $f7, $20, 22           #: parameters
    LOAD $f8, $20, 25           #: parameters
    lwc1 $f1, 8($sp)
    LOAD $f10, $20, 20          #: parameters
    LOAD $f11, $20, 23          #: parameters
    LOAD $f12, $20, 26          #: parameters
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
    LOAD $f8, $20, 21           #: parameters
    mul.s $f3, $f2, $f2
    mul.s $f7, $f6, $f6
    add.s $f3, $f7, $f3
    LOAD $f7, $20, 24           #: parameters
    mul.s $f0, $f0, $f7
    LOAD $f10, $20, 27          #: parameters
    mul.s $f9, $f9, $f10
    LOAD $f1, $20, 16           #: parameters
    LOAD $f13, $20, 17          #: parameters
    LOAD $f14, $20, 18          #: parameters
    lui $1, 16256
    sw $1, 116($sp)
    sw $zero, 112($sp)
    sw $zero, 108($sp)
    sw $zero, 104($sp)
    LOAD $2, $20, 2             #: parameters
    sw $2, 40($sp)
    add.s $f0, $f8, $f0
    add.s $f0, $f0, $f9
    mul.s $f7, $f0, $f0
    add.s $f3, $f3, $f7
    FPINVSQRT $f3, $f3
    mul.s $f4, $f3, $f0
    lwc1 $f0, 4($sp)
    mul.s $f10, $f2, $f3
    mul.s $f7, $f6, $f3
    swc1 $f0, 28($sp)
    swc1 $f0, 24($sp)
    swc1 $f0, 20($sp)
    lwc1 $f0, 96($sp)
    swc1 $f0, 76($sp)
$BB0_5:
    lwc1 $f30, 32($sp)
    addiu $21, $zero, 1
$BB0_6:                         #: ray
    mfc1 $1, $f4
    mfc1 $2, $f10
    addiu $10, $zero, 2
    addiu $5, $sp, 104
    swc1 $f7, 72($sp)
    swc1 $f10, 68($sp)
    swc1 $f4, 64($sp)
    swc1 $f1, 100($sp)
    and $1, $1, $8
    and $2, $2, $8
    mtc1 $1, $f0
    mfc1 $1, $f7
    mtc1 $2, $f3
    addiu $2, $zero, 1
    and $1, $1, $8
    mtc1 $1, $f2
    addiu $1, $zero, 1
    c.ule.s $f2, $f0
    movt $1, $zero, $fcc0
    c.ule.s $f2, $f3
    movt $2, $zero, $fcc0
    c.ule.s $f3, $f0
    lwc1 $f0, 96($sp)
    div.s $f19, $f0, $f10
    div.s $f20, $f0, $f7
    div.s $f21, $f0, $f4
    and $1, $2, $1
    addiu $2, $zero, 2
    movf $2, $9, $fcc0
    addiu $3, $2, -1
    movn $2, $zero, $1
    movn $3, $10, $1
    mfc1 $10, $f19
    mfc1 $11, $f20
    addiu $6, $2, 1
    xori $7, $2, 2
    mfc1 $14, $f21
    movz $6, $zero, $7
    addiu $11, $11, 4
    addiu $10, $10, 4
    mtc1 $10, $f22
    mtc1 $11, $f23
    sll $7, $2, 1
    addiu $14, $14, 4
    sll $15, $3, 1
    sll $1, $6, 2
    addu $22, $7, $2
    sll $2, $2, 2
    sll $10, $3, 2
    addu $fp, $15, $3
    addu $7, $1, $5
    sll $1, $6, 1
    addu $2, $2, $5
    addu $5, $10, $5
    addu $23, $1, $6
    mtc1 $14, $f24
    addiu $ra, $5, 28
    addiu $6, $7, 16
    addiu $5, $5, 16
    addiu $3, $7, 28
    addiu $1, $2, 28
    addiu $2, $2, 16
    sw $6, 56($sp)
    sw $5, 52($sp)
    sw $1, 80($sp)
    sw $2, 48($sp)
$BB0_7:
    swc1 $f14, 140($sp)
    swc1 $f13, 136($sp)
    swc1 $f1, 132($sp)
    swc1 $f4, 128($sp)
    mov.s $f4, $f1
    swc1 $f10, 124($sp)
    swc1 $f7, 120($sp)
    lwc1 $f0, 0($6)
    lwc1 $f2, 0($5)
    lwc1 $f3, 0($2)
    LOAD $f6, $20, 40           #: parameters
    LOAD $f7, $20, 41           #: parameters
    LOAD $f8, $20, 42           #: parameters
    LOAD $f10, $20, 43          #: parameters
    LOAD $f26, $20, 44          #: parameters
    LOAD $f27, $20, 45          #: parameters
    sub.s $f6, $f6, $f1
    sub.s $f26, $f26, $f13
    sub.s $f8, $f8, $f14
    sub.s $f27, $f27, $f14
    mtc1 $zero, $f1
    sub.s $f10, $f10, $f4
    mul.s $f9, $f23, $f6
    mul.s $f28, $f22, $f26
    mul.s $f6, $f20, $f6
    mul.s $f25, $f23, $f10
    FPMAX $f9, $f9, $f25
    mul.s $f10, $f20, $f10
    FPMIN $f6, $f6, $f10
    sub.s $f25, $f7, $f13
    mul.s $f10, $f19, $f26
    mul.s $f7, $f22, $f25
    FPMAX $f7, $f7, $f28
    mul.s $f28, $f24, $f27
    FPMIN $f7, $f9, $f7
    mul.s $f9, $f24, $f8
    mul.s $f8, $f21, $f8
    FPMAX $f9, $f9, $f28
    FPMIN $f9, $f9, $f30
    FPMIN $f7, $f7, $f9
    mul.s $f9, $f19, $f25
    FPMIN $f9, $f9, $f10
    FPMAX $f6, $f6, $f9
    mul.s $f9, $f21, $f27
    FPMIN $f8, $f8, $f9
    FPMAX $f8, $f8, $f1
    FPMAX $f29, $f6, $f8
    c.ule.s $f29, $f7
    bc1f $BB0_58                #: root_missed
    nop
    mov.s $f12, $f1
    lwc1 $f1, 96($sp)
    mov.s $f28, $f30
    mov.s $f30, $f7
    addiu $15, $zero, -1
    addiu $24, $zero, 0
    addiu $10, $zero, 0
    div.s $f1, $f1, $f3
    mul.s $f26, $f1, $f2
    mul.s $f27, $f0, $f1
    swc1 $f1, 92($sp)
    lwc1 $f1, 100($sp)
$BB0_9:
    move $20, $19
    move $5, $24
$BB0_10:
    sll $1, $10, 2
    sll $2, $10, 3
    addiu $24, $sp, 200
    negu $11, $10
    addu $1, $2, $1
    addu $14, $24, $1
$BB0_11:                        #: node
    mov.s $f31, $f30
    addu $2, $5, $4
    LOAD $7, $2, 0              #: node
    bltz $7, $BB0_21            #: carve
    and $19, $7, $12
    and $1, $7, $13
    bnez $1, $BB0_33            #: bare_leaf
    nop
    mov.s $f0, $f21
    and $1, $7, $17
    sltu $25, $7, $18
    xor $6, $1, $18
    srl $1, $7, 27
    andi $1, $1, 3
    addu $5, $1, $19
    LOAD $f6, $2, 1             #: node
    LOAD $f2, $2, 2             #: node
    movz.s $f0, $f19, $6
    movn.s $f0, $f20, $25
    c.olt.s $f0, $f12
    bc1f $BB0_15                #: !swap
    nop
    mov.s $f3, $f6
    j $BB0_16
    move $7, $19
$BB0_15:
    mov.s $f3, $f2
    move $7, $5
    mov.s $f2, $f6
    move $5, $19
$BB0_16:
    mov.s $f6, $f14
    mov.s $f7, $f24
    movz.s $f6, $f13, $6
    movz.s $f7, $f22, $6
    movn.s $f6, $f1, $25
    movn.s $f7, $f23, $25
    sub.s $f2, $f2, $f6
    sub.s $f3, $f3, $f6
    mul.s $f2, $f7, $f2
    FPMIN $f30, $f31, $f2
    c.ole.s $f29, $f30
    mul.s $f0, $f0, $f3
    FPMAX $f0, $f29, $f0
    bc1f $BB0_19                #: !near
    nop
    c.ole.s $f0, $f31
    bc1f $BB0_11                #: !far
    nop
    sll $1, $10, 2
    sll $2, $10, 3
    addiu $14, $14, 12
    addiu $11, $11, -1
    addiu $10, $10, 1
    addu $1, $2, $1
    addu $1, $24, $1
    swc1 $f31, 8($1)
    swc1 $f0, 4($1)
    j $BB0_11
    sw $7, 0($1)
$BB0_19:
    mov.s $f29, $f0
    mov.s $f30, $f31
    c.ole.s $f0, $f31
    bc1t $BB0_10                #: far
    move $5, $7
    move $19, $20
    j $BB0_46
    addiu $20, $zero, 0
$BB0_21:
    LOAD $f2, $2, 1             #: node
    LOAD $f0, $2, 2             #: node
    srl $1, $7, 29
    andi $24, $1, 3
    addiu $1, $zero, 2
    bne $24, $1, $BB0_23        #: !single
    nop
    mov.s $f3, $f21
    srl $1, $7, 27
    mov.s $f7, $f14
    mov.s $f6, $f0
    lwc1 $f4, 100($sp)
    mov.s $f1, $f12
    andi $2, $1, 3
    lwc1 $f1, 100($sp)
    xor $6, $2, $9
    movz.s $f3, $f19, $6
    movz.s $f7, $f13, $6
    movz.s $f3, $f20, $2
    movz.s $f7, $f4, $2
    c.olt.s $f3, $f12
    movt.s $f6, $f2, $fcc0
    c.olt.s $f3, $f12
    movt.s $f2, $f0, $fcc0
    sub.s $f6, $f6, $f7
    sub.s $f0, $f2, $f7
    mov.s $f2, $f24
    mul.s $f6, $f3, $f6
    FPMAX $f29, $f29, $f6
    movz.s $f2, $f22, $6
    movz.s $f2, $f23, $2
    mul.s $f0, $f2, $f0
    FPMIN $f30, $f31, $f0
    j $BB0_29
    nop
$BB0_23:
    mov.s $f3, $f20
    addiu $1, $zero, 3
    mov.s $f6, $f1
    addiu $6, $zero, 1
    xor $2, $24, $1
    lui $1, 4096
    and $1, $7, $1
    srl $1, $1, 28
    movz.s $f3, $f19, $2
    movz.s $f6, $f13, $2
    c.olt.s $f3, $f12
    movt $6, $zero, $fcc0
    beq $1, $6, $BB0_25         #: entry0
    sub.s $f2, $f2, $f6
    mov.s $f3, $f23
    movz.s $f3, $f22, $2
    mul.s $f2, $f3, $f2
    FPMIN $f31, $f31, $f2
    j $BB0_26
    nop
$BB0_25:
    mul.s $f2, $f3, $f2
    FPMAX $f29, $f29, $f2
$BB0_26:
    mov.s $f2, $f21
    mov.s $f3, $f14
    addiu $2, $zero, 1
    and $1, $7, $16
    srl $1, $1, 27
    movz.s $f2, $f19, $24
    movz.s $f3, $f13, $24
    c.olt.s $f2, $f12
    movt $2, $zero, $fcc0
    beq $1, $2, $BB0_28         #: entry1
    sub.s $f0, $f0, $f3
    mov.s $f2, $f24
    movz.s $f2, $f22, $24
    mul.s $f0, $f2, $f0
    FPMIN $f30, $f31, $f0
    j $BB0_29
    nop
$BB0_28:
    mov.s $f30, $f31
    mul.s $f0, $f2, $f0
    FPMAX $f29, $f29, $f0
$BB0_29:
    c.ule.s $f29, $f30
    and $1, $7, $13
    move $24, $19
    movz $19, $20, $1
    srl $1, $1, 23
    movf $24, $5, $fcc0
    movf $19, $20, $fcc0
    c.ule.s $f29, $f30
    xori $2, $1, 8
    addiu $1, $zero, 10
    movf $2, $1, $fcc0
    addiu $1, $zero, 8
    beq $2, $1, $BB0_9          #: carve_on
    nop
$BB0_30:
    beqz $2, $BB0_33            #: carve_leaf
    nop
$BB0_31:
    addiu $1, $zero, 10
    bne $2, $1, $BB0_49         #: never
    nop
$BB0_32:
    j $BB0_46
    addiu $20, $zero, 0
$BB0_33:
    sll $1, $19, 1
    sll $2, $19, 3
    addu $1, $2, $1
    lw $2, 60($sp)
    addu $19, $1, $2
    lw $1, 80($sp)
    lwc1 $f29, 0($1)
    j $BB0_35
    addiu $20, $zero, 0
$BB0_34:
    and $1, $10, $16
    bnez $1, $BB0_45            #: last
    addiu $19, $19, 10
$BB0_35:                        #: triangle
    addu $2, $23, $19
    lwc1 $f0, 0($3)
    lwc1 $f6, 0($ra)
    LOAD $f2, $2, 0             #: row0
    LOAD $f3, $2, 1             #: row0
    LOAD $f7, $2, 2             #: row0
    lwc1 $f8, %gp_rel($CPI0_3)($gp)
    addu $2, $fp, $19
    LOAD $f10, $2, 0            #: row1
    LOAD $f9, $2, 1             #: row1
    LOAD $f30, $2, 2            #: row1
    addu $2, $22, $19
    LOAD $f31, $2, 0            #: row2
    LOAD $f11, $2, 1            #: row2
    sub.s $f3, $f3, $f0
    sub.s $f7, $f7, $f0
    sub.s $f16, $f2, $f0
    sub.s $f0, $f11, $f29
    LOAD $f15, $2, 2            #: row2
    sub.s $f10, $f10, $f6
    sub.s $f17, $f9, $f6
    sub.s $f6, $f30, $f6
    lwc1 $f9, %gp_rel($CPI0_4)($gp)
    mul.s $f2, $f27, $f0
    mfc1 $7, $f3
    mfc1 $1, $f16
    mul.s $f25, $f26, $f0
    mfc1 $10, $f10
    mfc1 $5, $f17
    mfc1 $2, $f7
    and $24, $1, $8
    and $5, $5, $8
    and $10, $10, $8
    and $2, $2, $8
    mtc1 $5, $f1
    mfc1 $5, $f6
    sub.s $f11, $f3, $f2
    sub.s $f3, $f31, $f29
    sub.s $f2, $f15, $f29
    sub.s $f17, $f17, $f25
    mtc1 $10, $f31
    mul.s $f15, $f27, $f3
    mul.s $f30, $f27, $f2
    mfc1 $6, $f11
    sub.s $f15, $f16, $f15
    mul.s $f16, $f26, $f3
    sub.s $f7, $f7, $f30
    mul.s $f30, $f26, $f2
    sub.s $f10, $f10, $f16
    mfc1 $1, $f15
    sub.s $f6, $f6, $f30
    mul.s $f18, $f17, $f7
    and $1, $1, $8
    mtc1 $1, $f16
    and $1, $6, $8
    and $6, $7, $8
    mfc1 $25, $f10
    mtc1 $1, $f4
    mfc1 $1, $f17
    mul.s $f30, $f15, $f6
    mfc1 $7, $f6
    and $25, $25, $8
    and $1, $1, $8
    and $7, $7, $8
    mtc1 $25, $f5
    mtc1 $1, $f25
    FPMAX $f4, $f16, $f4
    FPMAX $f1, $f31, $f1
    LOAD $10, $19, 9            #: triangle
    mul.s $f31, $f11, $f6
    mul.s $f6, $f15, $f17
    mtc1 $24, $f16
    FPMAX $f5, $f5, $f25
    mul.s $f25, $f10, $f7
    mul.s $f10, $f10, $f11
    mtc1 $7, $f11
    mfc1 $1, $f7
    and $1, $1, $8
    sub.s $f7, $f18, $f31
    mtc1 $1, $f15
    and $1, $5, $8
    mfc1 $5, $f3
    sub.s $f30, $f30, $f25
    sub.s $f31, $f10, $f6
    mtc1 $1, $f17
    FPMAX $f4, $f4, $f15
    FPMAX $f5, $f5, $f11
    FPMAX $f1, $f1, $f17
    FPMIN $f18, $f7, $f30
    mtc1 $6, $f15
    mtc1 $2, $f11
    FPMAX $f17, $f7, $f30
    and $5, $5, $8
    mfc1 $1, $f0
    mtc1 $5, $f6
    and $1, $1, $8
    mtc1 $1, $f10
    FPMAX $f6, $f6, $f10
    mfc1 $1, $f2
    and $1, $1, $8
    mtc1 $1, $f10
    FPMAX $f4, $f4, $f5
    FPMAX $f5, $f16, $f15
    FPMAX $f10, $f6, $f10
    FPMAX $f1, $f1, $f10
    FPMAX $f5, $f5, $f11
    FPMAX $f6, $f17, $f31
    FPMAX $f1, $f5, $f1
    mul.s $f5, $f1, $f9
    FPMIN $f9, $f18, $f31
    mul.s $f1, $f1, $f8
    add.s $f4, $f5, $f4
    mul.s $f10, $f1, $f4
    c.ule.s $f6, $f10
    bc1t $BB0_37                #: negative
    neg.s $f8, $f10
    c.olt.s $f9, $f8
    bc1t $BB0_34                #: outside
    nop
$BB0_37:
    c.ole.s $f9, $f10
    bc1f $BB0_40                #: positive
    nop
    c.ult.s $f6, $f8
    bc1t $BB0_40                #: !exact
    nop
    EXACT $f7, $f30, $f31, $f3
$BB0_40:
    mul.s $f1, $f7, $f3
    mul.s $f0, $f0, $f30
    mul.s $f2, $f2, $f31
    add.s $f0, $f0, $f1
    add.s $f1, $f30, $f7
    add.s $f0, $f2, $f0
    LOAD $f2, $19, 0            #: triangle
    LOAD $f3, $19, 1            #: triangle
    LOAD $f4, $19, 2            #: triangle
    LOAD $f5, $19, 3            #: triangle
    LOAD $f6, $19, 4            #: triangle
    lwc1 $f7, 92($sp)
    add.s $f1, $f31, $f1
    FPMIN $f15, $f5, $f6
    FPMIN $f11, $f2, $f3
    FPMAX $f5, $f5, $f6
    FPMAX $f2, $f2, $f3
    FPMIN $f11, $f11, $f4
    FPMAX $f2, $f2, $f4
    mul.s $f7, $f7, $f0
    lwc1 $f0, 96($sp)
    div.s $f0, $f0, $f1
    LOAD $f1, $19, 5            #: triangle
    FPMIN $f15, $f15, $f1
    LOAD $f8, $19, 6            #: triangle
    LOAD $f9, $19, 7            #: triangle
    LOAD $f10, $19, 8           #: triangle
    lwc1 $f17, 100($sp)
    FPMAX $f6, $f8, $f9
    FPMAX $f1, $f5, $f1
    sub.s $f15, $f15, $f13
    FPMAX $f6, $f6, $f10
    sub.s $f1, $f1, $f13
    sub.s $f2, $f2, $f17
    sub.s $f11, $f11, $f17
    sub.s $f6, $f6, $f14
    mul.s $f4, $f22, $f15
    mul.s $f5, $f22, $f1
    FPMAX $f4, $f4, $f5
    mul.s $f3, $f23, $f2
    mul.s $f16, $f23, $f11
    mul.s $f2, $f20, $f2
    mul.s $f1, $f19, $f1
    FPMIN $f5, $f8, $f9
    FPMAX $f3, $f16, $f3
    mul.s $f8, $f24, $f6
    FPMIN $f5, $f5, $f10
    FPMIN $f3, $f3, $f4
    sub.s $f5, $f5, $f14
    mul.s $f4, $f24, $f5
    FPMAX $f4, $f4, $f8
    mul.s $f8, $f20, $f11
    FPMIN $f3, $f3, $f4
    FPMIN $f2, $f8, $f2
    mul.s $f4, $f19, $f15
    FPMIN $f1, $f4, $f1
    FPMAX $f1, $f2, $f1
    mul.s $f2, $f21, $f5
    mul.s $f4, $f21, $f6
    FPMIN $f2, $f2, $f4
    FPMAX $f1, $f1, $f2
    c.ule.s $f1, $f3
    mul.s $f7, $f0, $f7
    FPMAX $f2, $f7, $f1
    FPMIN $f2, $f2, $f3
    bc1f $BB0_34                #: box_empty
    nop
    c.olt.s $f2, $f12
    bc1t $BB0_34                #: behind
    nop
    c.ule.s $f2, $f28
    bc1f $BB0_34                #: farther
    nop
    mul.s $f1, $f31, $f0
    mul.s $f0, $f30, $f0
    mov.s $f28, $f2
    andi $1, $21, 1
    move $15, $19
    swc1 $f1, 152($sp)
    swc1 $f1, 88($sp)
    swc1 $f0, 84($sp)
    bnez $1, $BB0_34            #: !any
    swc1 $f0, 148($sp)
    j $BB0_54
    nop
$BB0_45:
    lwc1 $f1, 100($sp)
    addiu $19, $19, -10
$BB0_46:                        #: pop
    addiu $11, $11, 1
    beq $11, $9, $BB0_50        #: empty
    nop
    lwc1 $f29, -8($14)
    addiu $2, $14, -12
    c.ule.s $f29, $f28
    bc1f $BB0_46                #: beyond
    move $14, $2
    lw $24, 0($2)
    lwc1 $f0, 8($2)
    negu $10, $11
    FPMIN $f30, $f0, $f28
    j $BB0_9
    nop
$BB0_49:
    lwc1 $f7, 72($sp)
    lwc1 $f10, 68($sp)
    lwc1 $f4, 64($sp)
    lw $6, 56($sp)
    lw $5, 52($sp)
    lw $2, 48($sp)
    j $BB0_7
    addiu $20, $zero, 0
$BB0_50:
    andi $1, $21, 1
    beqz $1, $BB0_55            #: any
    nop
    bltz $15, $BB0_63           #: nothing
    nop
    LOAD $f1, $15, 0            #: hit
    LOAD $f0, $15, 1            #: hit
    LOAD $f5, $15, 2            #: hit
    mfc1 $2, $f0
    sub.s $f4, $f0, $f1
    lwc1 $f20, 76($sp)
    lwc1 $f19, 84($sp)
    lwc1 $f2, %gp_rel($CPI0_5)($gp)
    sub.s $f6, $f5, $f1
    LOAD $f0, $15, 3            #: hit
    LOAD $f7, $15, 4            #: hit
    sub.s $f8, $f7, $f0
    LOAD $f9, $15, 5            #: hit
    lwc1 $f18, 88($sp)
    LOAD $f14, $15, 6           #: hit
    LOAD $f15, $15, 7           #: hit
    LOAD $f16, $15, 8           #: hit
    sub.s $f11, $f9, $f0
    sub.s $f17, $f16, $f14
    mfc1 $3, $f0
    mul.s $f20, $f20, $f2
    and $2, $2, $8
    mfc1 $1, $f9
    lwc1 $f9, 64($sp)
    mtc1 $2, $f21
    mfc1 $2, $f1
    and $3, $3, $8
    mul.s $f2, $f4, $f19
    mul.s $f3, $f6, $f18
    and $5, $1, $8
    mfc1 $1, $f7
    mul.s $f13, $f8, $f19
    and $2, $2, $8
    and $1, $1, $8
    swc1 $f20, 116($sp)
    mtc1 $1, $f7
    add.s $f10, $f1, $f2
    mul.s $f2, $f11, $f18
    mtc1 $3, $f1
    add.s $f13, $f0, $f13
    mul.s $f0, $f17, $f18
    sub.s $f18, $f15, $f14
    FPMAX $f1, $f1, $f7
    mtc1 $5, $f7
    lui $5, 32768
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
    mtc1 $2, $f19
    mfc1 $2, $f5
    lwc1 $f5, 68($sp)
    and $2, $2, $8
    sub.s $f6, $f8, $f6
    lwc1 $f8, 72($sp)
    mul.s $f5, $f5, $f4
    mul.s $f9, $f9, $f13
    mul.s $f8, $f8, $f6
    add.s $f5, $f8, $f5
    FPMAX $f8, $f19, $f21
    add.s $f5, $f9, $f5
    mfc1 $3, $f5
    mfc1 $1, $f14
    mul.s $f5, $f13, $f13
    and $1, $1, $8
    mtc1 $1, $f7
    mfc1 $1, $f15
    and $1, $1, $8
    mtc1 $1, $f9
    FPMAX $f7, $f7, $f9
    mfc1 $1, $f16
    mtc1 $2, $f9
    and $2, $3, $5
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
    mfc1 $3, $f5
    xor $1, $3, $2
    xor $2, $1, $5
    FPMAX $f1, $f7, $f1
    mtc1 $2, $f5
    mul.s $f6, $f6, $f5
    mul.s $f8, $f13, $f5
    mul.s $f4, $f4, $f5
    mul.s $f1, $f1, $f10
    swc1 $f8, 164($sp)
    swc1 $f4, 160($sp)
    swc1 $f6, 156($sp)
    mul.s $f5, $f6, $f1
    add.s $f5, $f5, $f3
    LOAD $f3, $20, 28           #: parameters
    swc1 $f6, 44($sp)
    sub.s $f7, $f3, $f5
    mov.s $f9, $f5
    mul.s $f5, $f4, $f1
    mul.s $f1, $f8, $f1
    add.s $f13, $f5, $f2
    LOAD $f2, $20, 29           #: parameters
    add.s $f14, $f1, $f0
    mul.s $f3, $f6, $f7
    LOAD $f0, $20, 30           #: parameters
    sub.s $f10, $f2, $f13
    mul.s $f2, $f4, $f10
    sub.s $f4, $f0, $f14
    add.s $f2, $f3, $f2
    mul.s $f0, $f8, $f4
    add.s $f0, $f2, $f0
    c.ule.s $f0, $f12
    bc1t $BB0_61                #: !lit
    nop
    lwc1 $f1, %gp_rel($CPI0_7)($gp)
    mul.s $f2, $f7, $f7
    lwc1 $f30, %gp_rel($CPI0_1)($gp)
    swc1 $f20, 76($sp)
    addiu $21, $zero, 0
    mul.s $f1, $f20, $f1
    mul.s $f0, $f1, $f0
    mul.s $f1, $f10, $f10
    add.s $f1, $f2, $f1
    mul.s $f2, $f4, $f4
    add.s $f1, $f1, $f2
    FPINVSQRT $f1, $f1
    mul.s $f0, $f0, $f1
    mul.s $f0, $f1, $f0
    mul.s $f0, $f1, $f0
    mov.s $f1, $f9
    swc1 $f0, 36($sp)
    j $BB0_6
    swc1 $f0, 144($sp)
$BB0_54:
    lwc1 $f1, 100($sp)
    move $15, $19
$BB0_55:
    lwc1 $f20, 76($sp)
    bltz $15, $BB0_59           #: nothing
    nop
    lw $3, 40($sp)
    bnez $3, $BB0_60            #: !last_bounce
    nop
    j $BB0_2
    nop
$BB0_58:
    lwc1 $f20, 76($sp)
    andi $1, $21, 1
    bnez $1, $BB0_64            #: !any
    nop
$BB0_59:
    LOAD $f0, $20, 31           #: parameters
    lwc1 $f1, 36($sp)
    lwc1 $f2, 20($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 20($sp)
    swc1 $f2, 104($sp)
    LOAD $f0, $20, 32           #: parameters
    lwc1 $f2, 24($sp)
    mul.s $f0, $f1, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 24($sp)
    swc1 $f2, 108($sp)
    LOAD $f0, $20, 33           #: parameters
    lw $3, 40($sp)
    mul.s $f0, $f1, $f0
    lwc1 $f1, 28($sp)
    add.s $f1, $f1, $f0
    swc1 $f1, 28($sp)
    swc1 $f1, 112($sp)
    lwc1 $f1, 100($sp)
    beqz $3, $BB0_2             #: last_bounce
    nop
$BB0_60:
    swc1 $f20, 76($sp)
    RAND $f0
    lwc1 $f11, 96($sp)
    RAND $f2
    mov.s $f12, $f1
    lwc1 $f3, 164($sp)
    mfc1 $2, $f3
    lwc1 $f4, %gp_rel($CPI0_8)($gp)
    lwc1 $f15, 44($sp)
    addiu $3, $3, -1
    sw $3, 40($sp)
    sub.s $f1, $f11, $f0
    FPINVSQRT $f5, $f1
    mul.s $f2, $f2, $f4
    lui $1, 32768
    and $1, $2, $1
    lui $2, 16256
    or $2, $1, $2
    FPINVSQRT $f4, $f0
    mul.s $f0, $f0, $f4
    mtc1 $2, $f6
    add.s $f8, $f3, $f6
    COS $f7, $f2
    SIN $f2, $f2
    lwc1 $f4, 160($sp)
    mul.s $f1, $f1, $f5
    mul.s $f5, $f15, $f4
    mul.s $f2, $f2, $f0
    mul.s $f0, $f7, $f0
    lwc1 $f7, %gp_rel($CPI0_9)($gp)
    mul.s $f3, $f1, $f3
    mul.s $f9, $f15, $f1
    mul.s $f1, $f1, $f4
    div.s $f7, $f7, $f8
    mul.s $f8, $f4, $f4
    mul.s $f8, $f8, $f7
    mul.s $f5, $f5, $f7
    mul.s $f10, $f6, $f5
    add.s $f8, $f6, $f8
    mul.s $f6, $f15, $f6
    mul.s $f5, $f2, $f5
    mul.s $f8, $f2, $f8
    mul.s $f10, $f0, $f10
    add.s $f8, $f10, $f8
    mul.s $f10, $f15, $f6
    mul.s $f7, $f10, $f7
    add.s $f10, $f1, $f8
    add.s $f7, $f7, $f11
    mul.s $f7, $f0, $f7
    mul.s $f0, $f0, $f6
    add.s $f1, $f5, $f7
    sub.s $f0, $f3, $f0
    add.s $f7, $f9, $f1
    mul.s $f1, $f2, $f4
    sub.s $f4, $f0, $f1
    j $BB0_5
    mov.s $f1, $f12
$BB0_61:
    lw $3, 40($sp)
    bnez $3, $BB0_60            #: !last_bounce
    mov.s $f1, $f9
    j $BB0_2
    nop
$BB0_63:
    lwc1 $f20, 76($sp)
$BB0_64:
    LOAD $f0, $20, 34           #: parameters
    lwc1 $f3, 20($sp)
    mul.s $f0, $f20, $f0
    add.s $f3, $f3, $f0
    swc1 $f3, 104($sp)
    LOAD $f0, $20, 35           #: parameters
    lwc1 $f2, 24($sp)
    mul.s $f0, $f20, $f0
    add.s $f2, $f2, $f0
    swc1 $f2, 108($sp)
    LOAD $f0, $20, 36           #: parameters
    lwc1 $f1, 28($sp)
    mul.s $f0, $f20, $f0
    add.s $f1, $f1, $f0
    j $BB0_3
    swc1 $f1, 112($sp)
$BB0_65:
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
