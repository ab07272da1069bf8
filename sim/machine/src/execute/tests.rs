//! Small programs, right and wrong.

use super::*;
use crate::description::MachineDescription;

/// Samples are the item and the dimension.
struct Numbers;

impl Special for Numbers {
    fn random(&self, item: u32, dimension: u32) -> f32 {
        (100 * item + dimension) as f32
    }
}

/// Words of the memory of these programs; items write those from [`WRITTEN`] on.
const WORDS: u32 = 512;
const WRITTEN: u32 = 32;

/// What the items of a program have written. The program has `items` items, whose number is in `$5`; their code is `body`.
fn executed(set_up: &str, body: &str, items: u32) -> Result<Vec<Option<u32>>, Box<Fault>> {
    let listing = format!(
        "main:\n addiu $sp, $sp, -64\n{set_up}\n ATOMIC_INC $5, 0\n slti $1, $5, {items}\n beqz $1, $end\n nop\n\
         $item:\n{body}\n ATOMIC_INC $5, 0\n slti $1, $5, {items}\n bnez $1, $item\n nop\n\
         $end:\n jr $ra\n addiu $sp, $sp, 64\n"
    );
    let machine = MachineDescription::load("trax", &[]).unwrap();
    let program = Arc::new(Program::new("test", &listing, &machine, 1).unwrap());
    let memory = Memory::new((0..WORDS).map(|word| 1000 + word).collect(), WRITTEN..WORDS);
    let mut executor = Executor::new(Arc::clone(&program), memory, Numbers, items)?;
    let mut counts = vec![0; program.code.runs.len()];
    let mut words = vec![];
    executor.start(&mut Tape::new(&mut words, &mut counts))?;
    let (first, later) = executor.entries().unwrap();
    for item in 0..=items {
        let entry = if item == 0 { first } else { later };
        executor.record(item, entry, &mut Tape::new(&mut words, &mut counts))?;
    }
    executor.check()?;
    Ok((WRITTEN..WORDS).map(|address| executor.memory().written(address)).collect())
}

/// What an item writes whose code leaves it in `$6`.
fn result(body: &str) -> u32 {
    let store = format!("{body}\n addiu $7, $5, {WRITTEN}\n STORE $6, $7, 0");
    executed("", &store, 1).unwrap()[0].unwrap()
}

/// The same for `$f6`.
fn float(body: &str) -> f32 {
    f32::from_bits(result(&format!("{body}\n mfc1 $6, $f6")))
}

fn fault(set_up: &str, body: &str) -> String {
    executed(set_up, body, 3).unwrap_err().to_string()
}

#[test]
fn integers() {
    for (body, expected) in [
        ("addiu $3, $zero, -5\n addiu $4, $zero, 3\n addu $6, $3, $4", -2),
        ("addiu $3, $zero, -5\n addiu $4, $zero, 3\n subu $6, $3, $4", -8),
        ("addiu $3, $zero, -5\n negu $6, $3", 5),
        ("addiu $3, $zero, -5\n addiu $4, $zero, 3\n mul $6, $3, $4", -15),
        ("addiu $3, $zero, 12\n andi $6, $3, 10", 8),
        ("addiu $3, $zero, 12\n ori $6, $3, 3", 15),
        ("addiu $3, $zero, 12\n xori $6, $3, 10", 6),
        ("addiu $3, $zero, 12\n not $6, $3", -13),
        ("addiu $3, $zero, -8\n sra $6, $3, 1", -4),
        ("addiu $3, $zero, -8\n srl $6, $3, 28", 15),
        ("addiu $3, $zero, -8\n sll $6, $3, 2", -32),
        ("addiu $3, $zero, 3\n addiu $4, $zero, 5\n sllv $6, $3, $4", 96),
        ("addiu $3, $zero, -1\n slti $6, $3, 0", 1),
        ("addiu $3, $zero, -1\n sltiu $6, $3, 7", 0),
        ("addiu $3, $zero, 7\n sltiu $6, $3, -1", 1),
        ("lui $3, 1\n move $6, $3", 65536),
        ("addiu $6, $zero, 1\n addiu $3, $zero, 2\n movn $6, $3, $zero", 1),
        ("addiu $6, $zero, 1\n addiu $3, $zero, 2\n movz $6, $3, $zero", 2),
        ("addiu $zero, $zero, 9\n move $6, $zero", 0),
        ("addiu $4, $zero, 2\n LOAD $6, $4, 5", 1007),
        ("RAND $f1\n RAND $f1\n trunc.w.s $f1, $f1\n mfc1 $6, $f1", 3),
        ("addiu $3, $zero, -2\n sb $3, 5($sp)\n lb $6, 5($sp)", -2),
    ] {
        let body = if body.contains("sb ") { format!("sw $zero, 4($sp)\n {body}") } else { body.to_owned() };
        assert_eq!(result(&body) as i32, expected, "{body}");
    }
    // Bytes are in big-endian order.
    let bytes = "lui $3, 258\n ori $3, $3, 772\n sw $3, 8($sp)\n lbu $6, 9($sp)";
    assert_eq!(result(bytes), 2);
}

#[test]
fn floats() {
    let two = "addiu $3, $zero, 2\n mtc1 $3, $f2\n cvt.s.w $f2, $f2\n addiu $3, $zero, -3\n mtc1 $3, $f3\n cvt.s.w $f3, $f3\n";
    for (body, expected) in [
        ("add.s $f6, $f2, $f3", -1.0f32),
        ("sub.s $f6, $f2, $f3", 5.0),
        ("mul.s $f6, $f2, $f3", -6.0),
        ("div.s $f6, $f2, $f3", 2.0 / -3.0),
        ("sqrt.s $f6, $f2", 2f32.sqrt()),
        ("neg.s $f6, $f3", 3.0),
        ("abs.s $f6, $f3", 3.0),
        ("FPMIN $f6, $f2, $f3", -3.0),
        ("FPMAX $f6, $f2, $f3", 2.0),
        ("FPINVSQRT $f6, $f2", render::shading::inverse_square_root(2.0)),
        ("SIN $f6, $f2", render::shading::sine(2.0)),
        ("COS $f6, $f2", render::shading::cosine(2.0)),
        ("div.s $f6, $f3, $f2\n trunc.w.s $f6, $f6\n cvt.s.w $f6, $f6", -1.0),
        ("div.s $f6, $f3, $f2\n cvt.w.s $f6, $f6\n cvt.s.w $f6, $f6", -2.0),
        ("mov.s $f6, $f2\n c.olt.s $f3, $f2\n movt.s $f6, $f3, $fcc0", -3.0),
        ("mov.s $f6, $f2\n c.olt.s $f3, $f2\n movf.s $f6, $f3, $fcc0", 2.0),
        // 0/0 is unordered.
        (
            "mov.s $f6, $f2\n mtc1 $zero, $f4\n div.s $f4, $f4, $f4\n c.ule.s $f4, $f2\n movt.s $f6, $f3, $fcc0",
            -3.0,
        ),
        (
            "mov.s $f6, $f2\n mtc1 $zero, $f4\n div.s $f4, $f4, $f4\n c.ole.s $f4, $f2\n movt.s $f6, $f3, $fcc0",
            2.0,
        ),
        ("sdc1 $f2, 8($sp)\n ldc1 $f6, 8($sp)", 2.0),
        ("sdc1 $f2, 8($sp)\n lwc1 $f6, 8($sp)", -3.0),
    ] {
        let found = float(&format!("{two}{body}"));
        assert_eq!(found.to_bits(), expected.to_bits(), "{body}: {found} {expected}");
    }
}

#[test]
fn items_that_depend_on_others_are_found_out() {
    let store = format!("addiu $7, $5, {WRITTEN}\n STORE $6, $7, 0");
    // A register, the local store, and global memory, as an earlier item has left them.
    let register = fault(
        "addiu $8, $zero, 1",
        &format!("addu $6, $8, $zero\n addu $8, $8, $5\n addiu $8, $8, 1\n {store}"),
    );
    assert!(
        register.contains("it reads $8 as an earlier item has left it") && register.contains("line 9"),
        "{register}"
    );
    let local =
        fault("sw $zero, 16($sp)", &format!("lw $6, 16($sp)\n addiu $8, $5, 1\n sw $8, 16($sp)\n {store}"));
    assert!(local.contains("of the local store as an earlier item has left it"), "{local}");
    let global = fault("", &format!("addiu $6, $zero, {WRITTEN}\n LOAD $6, $6, 0\n {store}"));
    assert!(global.contains("word 32"), "{global}");
    let shared = fault("", &format!("addiu $7, $zero, {WRITTEN}\n STORE $5, $7, 0"));
    assert!(shared.contains("stores to word 32, which another item has written"), "{shared}");
    // What the set-up leaves and no item changes can be read, as can what the item itself has written.
    let set_up = "addiu $8, $zero, 41\n sw $8, 16($sp)";
    let body = format!(
        "lw $6, 16($sp)\n addu $6, $6, $5\n sw $6, 20($sp)\n lw $6, 20($sp)\n {store}\n LOAD $6, $7, 0"
    );
    assert_eq!(executed(set_up, &body, 3).unwrap()[..4], [Some(41), Some(42), Some(43), None]);
    // A value that is moved and not used does no harm.
    let moved = format!("move $9, $8\n addu $8, $8, $5\n move $6, $5\n {store}");
    assert_eq!(executed("addiu $8, $zero, 1", &moved, 3).unwrap()[2], Some(2));
}

/// One item in two hundred leaves something, and it is not among those that are executed beforehand.
#[test]
fn an_item_that_leaves_something_late_is_found_out() {
    let store = format!("addiu $7, $5, {WRITTEN}\n STORE $6, $7, 0");
    let late =
        |change: &str| format!("xori $1, $5, 100\n bnez $1, $over\n nop\n {change}\n $over:\n {store}");
    let faults = |set_up: &str, body: &str| executed(set_up, body, 200).unwrap_err().to_string();
    let register = faults("addiu $8, $zero, 1", &format!("move $6, $8\n {}", late("addiu $8, $8, 1")));
    assert!(register.contains("it reads $8 as an earlier item has left it"), "{register}");
    let local = faults("sw $zero, 16($sp)", &format!("lw $6, 16($sp)\n {}", late("sw $5, 16($sp)")));
    assert!(local.contains("it reads byte 32720 of the local store"), "{local}");
    // What is left and not used does no harm.
    let moved = format!("move $9, $8\n move $6, $5\n {}", late("addiu $8, $8, 1"));
    assert_eq!(executed("addiu $8, $zero, 1", &moved, 200).unwrap()[150], Some(150));
}

#[test]
fn what_a_program_does_wrong_names_line_and_address() {
    for (body, expected) in [
        (
            "addiu $6, $zero, 599\n LOAD $6, $6, 1",
            "line 10, in item 0: it loads word 600, which is outside memory",
        ),
        ("addiu $6, $zero, 3\n STORE $6, $6, 1", "it stores to word 4; only the picture can be written"),
        ("lw $6, 4096($sp)", "is outside the 32768 bytes of the local store"),
        ("addiu $6, $sp, -32768\n sw $5, 0($6)", "byte -64 is outside"),
        ("lw $6, 2($sp)", "is not the address of a word"),
        ("lw $6, 24($sp)\n LOAD $7, $6, 0", "it reads byte 32728 of the local store"),
        ("$loop:\n j $loop\n nop", "instructions without asking for a new item"),
        ("$loop:\n RAND $f1\n j $loop\n nop", "it asks for more than the 254 random numbers"),
        ("addiu $6, $zero, 9\n ENTRY $f1, $6", "there is no lane 9"),
    ] {
        let message = fault("", body);
        assert!(message.starts_with("test, line ") && message.contains(expected), "{body}: {message}");
    }
}
