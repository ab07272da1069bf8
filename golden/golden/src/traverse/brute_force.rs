//! Testing every triangle: what every structure has to agree with.

use super::NoObserver;
use super::query::Query;
use crate::ray::{Hit, Mode, Ray, TraversalRay};
use crate::triangle::Triangle;

/// The nearest hit among all `triangles`, the lowest index first among equals.
#[must_use]
pub fn brute_force(triangles: &[Triangle], ray: &Ray, mode: Mode) -> Option<Hit> {
    let ray = TraversalRay::new(ray, mode)?;
    let mut query = Query::<false>::new(&ray, triangles);
    for (slot, triangle) in (0..).zip(triangles) {
        query.triangle(triangle, slot, &mut NoObserver);
    }
    query.hit()
}
