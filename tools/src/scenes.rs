//! Pictures that nobody has looked at: what a page of any picture must keep is asked of their pages.

/// Profiles in turn: paper, dots on a grid, dots anywhere, pins.
pub const PROFILES: [&str; 4] = ["swell-a4", "index-basic-d", "braillerap", "monarch"];

/// Blobs and stripes, one in three of them under strong noise: RGBA, `size` pixels wide and high.
pub fn picture(seed: u64, size: usize) -> Vec<u8> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 40) as f32 / (1_u64 << 24) as f32
    };
    let noise = if seed.is_multiple_of(3) { 0.5 } else { 0.02 };
    let blobs: Vec<[f32; 6]> = (0..4 + seed % 9).map(|_| std::array::from_fn(|_| random())).collect();
    let mut pixels = Vec::with_capacity(4 * size * size);
    for i in 0..size * size {
        let (x, y) = ((i % size) as f32 / size as f32, (i / size) as f32 / size as f32);
        let mut colour = [0.9, 0.9, 0.85];
        for [cx, cy, r, red, green, blue] in &blobs {
            let radius = 0.05 + 0.3 * r;
            let (dx, dy) = (x - cx, y - cy);
            let inside = match (100.0 * r) as u32 % 3 {
                0 => dx.hypot(dy) < radius,
                1 => dx.abs().max(dy.abs()) < radius,
                _ => (8.0 * dx + 20.0 * dy * r).sin() > 0.6,
            };
            if inside {
                colour = [*red, *green, *blue];
            }
        }
        let grain = noise * (random() - 0.5);
        pixels.extend(colour.map(|channel: f32| (255.0 * (channel + grain).clamp(0.0, 1.0)) as u8));
        pixels.push(255);
    }
    pixels
}
