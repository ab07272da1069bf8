//! Miss registers: so many lines are on their way to a cache at a time, and no more.

use crate::driver::{Driver, LINE_WORDS, description};
use memory::description::{BankBy, Description};
use memory::{Access, Answer, Client};

fn client(port: u16) -> Client {
    Client { port, number: 0 }
}

/// Every port asks for a new line in each of so many cycles. Returns, for each cycle, how many lines are on their way to all of
/// them.
fn under_way(driver: &mut Driver, ports: u16, cycles: u32) -> Vec<usize> {
    let (mut line, mut unknown, mut arrivals) = (0, 0, vec![]);
    (0..cycles)
        .map(|_| {
            for port in 0..ports {
                match driver.ask(client(port), Access::Load, line * LINE_WORDS) {
                    Answer::Later => unknown += 1,
                    Answer::At(arrival) => arrivals.push(arrival),
                    Answer::Refused => continue,
                    Answer::Kept => panic!("the channels have room"),
                }
                line += 1;
            }
            arrivals.retain(|arrival| *arrival > driver.now);
            let lines = unknown + arrivals.len();
            driver.step();
            unknown -= driver.told.len();
            arrivals.extend(driver.told.drain(..).map(|told| told.arrival));
            lines
        })
        .collect()
}

#[test]
fn registers_limit_the_lines_on_their_way_and_are_all_used() {
    for registers in [1, 3, 8] {
        let mut description = Description { ports_per_partition: 2, ..description() };
        (description.l1.miss_registers, description.network.latency_cycles) = (registers, registers % 3);
        // So that no bank is in the way.
        description.l2.bank_by = BankBy::Line;
        let mut driver = Driver::new(&description);
        let lines = under_way(&mut driver, 2, 2000);
        let all = 2 * registers as usize;
        assert!(lines.iter().all(|lines| *lines <= all), "{registers}: {:?}", lines.iter().max());
        // A register is free from the cycle on in which its line arrives, and taken by the next load.
        assert!(lines[20..].iter().all(|lines| *lines == all), "{registers}: {lines:?}");
        let counts = driver.memory.l1_counts();
        assert_eq!(counts.loads + counts.register_conflicts, 2 * 2000, "all others are refused");
        assert_eq!(driver.memory.l2_counts().register_conflicts, 0);

        // Of the second level: those of all ports together.
        (description.l1.miss_registers, description.l2.miss_registers) = (0, registers);
        description.network.latency_cycles = 0;
        let mut driver = Driver::new(&description);
        let lines = under_way(&mut driver, 2, 2000);
        assert!(lines[20..].iter().all(|lines| *lines == registers as usize), "{registers}: {lines:?}");
        assert!(driver.memory.l2_counts().register_conflicts > 1000);
        assert_eq!(driver.memory.l1_counts().register_conflicts, 0);
    }
}

#[test]
fn a_line_takes_one_register_for_all_who_load_from_it() {
    let mut description = Description { ports_per_partition: 2, ..description() };
    (description.l1.miss_registers, description.l2.miss_registers) = (1, 1);
    let mut driver = Driver::new(&description);
    assert_eq!(driver.ask(client(0), Access::Load, 64), Answer::Later);
    assert_eq!(driver.ask(client(0), Access::Load, 65), Answer::Later, "it joins in the first level");
    driver.step();
    assert_eq!(driver.ask(client(1), Access::Load, 65), Answer::Later, "it joins in the second level");
    assert_eq!(driver.ask(client(0), Access::Load, 96), Answer::Refused);
    assert_eq!(driver.memory.l1_counts().register_conflicts, 1);
    assert!(matches!(driver.ask(client(0), Access::Store, 96), Answer::At(_)), "a store takes none");
    driver.go_to(40);
    assert!(driver.told.iter().all(|told| told.arrival <= 40));
    assert!(matches!(driver.ask(client(0), Access::Load, 66), Answer::At(_)), "the line has arrived");
    assert_eq!(driver.ask(client(0), Access::Load, 128), Answer::Later, "and its register is free");
}
