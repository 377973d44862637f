//! Tests of `squares`.

use super::*;

/// Numbers in 0..1 that look random and are the same every time.
struct Numbers(u32);

impl Numbers {
    fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 8) as f32 / (1 << 24) as f32
    }

    fn place(&mut self) -> MmPoint {
        MmPoint::new(76.0 * self.next() - 8.0, 56.0 * self.next() - 8.0)
    }
}

/// Those of 60 by 40 mm, and some of them.
fn marked(count: usize, numbers: &mut Numbers) -> (Squares, MarkedSquares) {
    let squares = Squares::of(MmRect::new(MmPoint::zero(), MmPoint::new(60.0, 40.0)));
    let mut marked = MarkedSquares::none_of(&squares);
    (0..count).filter_map(|_| squares.index(numbers.place())).for_each(|index| marked.mark(index));
    (squares, marked)
}

#[test]
fn on_a_way_the_first_square_is_found_as_if_each_step_were_looked_at() {
    let mut numbers = Numbers(7);
    let mut found = [0, 0];
    for count in [0, 3, 30, 600] {
        let (squares, marked) = marked(count, &mut numbers);
        for _ in 0..500 {
            let (at, to, reach) = (numbers.place(), numbers.place(), 90.0 * numbers.next());
            let (sin, cos) = (std::f32::consts::TAU * numbers.next()).sin_cos();
            let direction = MmVector::new(cos, sin);
            let mut steps = (0..).map(|step| 0.5 * SQUARE * step as f32).take_while(|distance| *distance <= reach);
            let first = steps.find(|distance| marked.holds(at + direction * *distance, &squares));
            assert_eq!(marked.first_in(&squares, at, direction, reach), first, "{count} from {at:?} to {direction:?}");
            let end = 10.0 * numbers.next();
            let length = (to - at).length();
            let steps = (length / SQUARE).ceil().max(1.0);
            let meets = (0..=steps as u32)
                .map(|step| step as f32 / steps)
                .any(|along| (1.0 - along) * length > end && marked.holds(at.lerp(to, along), &squares));
            assert_eq!(marked.meets(&squares, at, to, end), meets, "{count} from {at:?} to {to:?}, without {end}");
            found = [found[0] + usize::from(first.is_some()), found[1] + usize::from(meets)];
        }
    }
    assert!(found.iter().all(|count| (200..1800).contains(count)), "{found:?}");
}

#[test]
fn far_from_all_of_them_many_squares_are_passed_at_once_and_never_one_of_them() {
    let squares = Squares::of(MmRect::new(MmPoint::zero(), MmPoint::new(60.0, 40.0)));
    let mut marked = MarkedSquares::none_of(&squares);
    let at = MmPoint::new(30.25, 20.25);
    marked.mark(squares.index(at).expect("it is in the figure"));
    let blank = |right: f32, down: f32| marked.blank_around(at + MmVector::new(right, down), &squares);
    assert_eq!(blank(0.0, 0.0), None);
    assert_eq!(blank(0.5, 0.0), Some(0));
    // its block has columns 60 to 63, and one block lies between it and that of column 70
    assert_eq!([blank(5.0, 0.0), blank(0.0, -5.0), blank(20.0, 3.0)], [Some(4), Some(8), Some(36)]);
    assert_eq!([blank(100.0, 0.0), blank(-30.5, 0.0), blank(0.0, -25.5)], [Some(140), Some(0), Some(10)], "outside");
    let empty = MarkedSquares::none_of(&squares);
    assert!(empty.blank_around(at, &squares) > Some(100));
}
