//! What one would rather look at than read: pictures and their comparison, charts, and the page that holds them.

pub mod picture;
pub mod plot;
pub mod report;
