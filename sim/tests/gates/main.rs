//! The hardware as gates against the word graph it comes from.

mod simulation;
