//! Pictures that nobody has looked at: what a page of any picture must keep is asked of their pages.

use crate::rng::Rng;

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

/// A drawing of so many shapes and lines in random places, some filled, with strokes 1 to 4 wide, on 800 by 600.
pub fn drawing(seed: u64, count: usize) -> String {
    let mut rng = Rng::new(seed);
    let mut svg = String::from("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 600'>");
    svg.push_str("<rect width='800' height='600' fill='#fff'/>");
    for _ in 0..count {
        let mut place = || format!("{:.1} {:.1}", rng.between(20.0, 780.0), rng.between(20.0, 580.0));
        let [a, b, c, d] = std::array::from_fn(|_| place());
        let (rx, ry, turn) = (rng.between(4.0, 120.0), rng.between(8.0, 90.0), rng.between(0.0, 180.0));
        let kind = rng.below(6);
        let shape = match kind {
            0 => format!("<circle r='{rx:.1}' transform='translate({a})'/>"),
            1 => format!("<ellipse rx='{rx:.1}' ry='{ry:.1}' transform='translate({a}) rotate({turn:.0})'/>"),
            2 => format!("<rect width='{:.1}' height='{ry:.1}' transform='translate({a})'/>", 2.0 * rx),
            3 => format!("<path d='M{a} L{b}'/>"),
            4 => format!("<path d='M{a} L{b} {c} {d}'/>"),
            _ => format!("<path d='M{a} C{b} {c} {d}'/>"),
        };
        let hue = rng.below(360);
        let fill = if kind < 3 && rng.coin() { format!("hsl({hue},70%,50%)") } else { "none".to_owned() };
        let width = rng.between(1.0, 4.0);
        svg.push_str(&format!("<g stroke='#000' stroke-width='{width:.1}' fill='{fill}'>{shape}</g>"));
    }
    svg.push_str("</svg>");
    svg
}
