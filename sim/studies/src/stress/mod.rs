//! Every method, judged by an exact oracle on inputs made to break it.
//!
//! A [`Method`] is a structure with an arithmetic: binary32 in both modes, a narrower format in both variants, or the
//! netlist of the pipeline. [`Bench`] runs methods over one [`Case`](stress::cases::Case) and counts, per
//! method, how the result differs from the exact answer ([`stress::oracle`]) and from testing every triangle:
//!
//! * *false miss*, *false hit*: the ray exactly hits something and finds nothing, or the reverse;
//! * *wrong nearest*: the triangle found is not at the exactly least distance;
//! * *NaN*: the result is NaN;
//! * *lost*: the result differs in some bit from testing every triangle with the same triangle test, so traversal is wrong;
//! * *triangle test*: how often testing every triangle itself differs from the exact answer;
//! * *excess visits*: the ray is slow. It visits more nodes than five times the most of eight rays turned by a millionth, plus
//!   four times the depth of the tree.
//!
//! [`search()`] walks a ray one unit in the last place at a time towards the least interval that a method computes for a box
//! whose triangle the ray hits; [`slice()`] pictures the rays around a failure.
//!
//! # What fails where, and what to use instead
//! | method | fails | use instead |
//! |---|---|---|
//! | `binary32-fast` | at corners and edges of boxes, by rounding; along axes where a face contains the ray | `binary32-robust` |
//! | any format, `naive` | as above, and where boxes are thinner than a unit in the last place; with few exponent bits, almost everywhere | the same format, `conservative` |
//! | `binary32-robust`, any format, `conservative` | nowhere; coarse formats visit more nodes | |

mod bench;
mod hardware;
mod method;
mod search;
mod slice;
pub mod study;

pub use bench::{Bench, Cell, aimed_cells};
pub use hardware::{Hardware, narrow_case};
pub use method::{Arithmetic, Instance, Method, MethodError, Structures};
pub use search::{Found, search};
pub use slice::{Slice, slice};
