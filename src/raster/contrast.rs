//! Contrasts: how far one colour is from another, as a vector with a value of each plane.

/// How far `a` is from `b`.
#[inline(always)]
pub fn less(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    std::array::from_fn(|plane| a[plane] - b[plane])
}

/// The scalar product of two contrasts: of unit vectors, the cosine between them.
#[inline(always)]
pub fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The square of its length.
#[inline(always)]
pub fn square(of: [f32; 3]) -> f32 {
    dot(of, of)
}

/// The length of a contrast: how strong it is.
#[inline(always)]
pub fn length(of: [f32; 3]) -> f32 {
    square(of).sqrt()
}

/// How far apart two colours are.
#[inline(always)]
pub fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    length(less(a, b))
}

#[cfg(test)]
mod tests;
