//! Tests of `mathtext`.

use super::*;

fn said(text: &str) -> Option<(String, usize)> {
    read(text).map(|formula| (formula.string, formula.signs))
}

fn is(string: &str, signs: usize) -> Option<(String, usize)> {
    Some((string.to_owned(), signs))
}

#[test]
fn formulas_of_one_line_are_read() {
    assert_eq!(said(r"$\mathdefault{10^{-3}}$"), is("10\u{207b}\u{b3}", 4));
    assert_eq!(said(r"$\mathdefault{-2.5}$"), is("\u{2212}2.5", 4));
    assert_eq!(said("Energy $E = m c^2$ in kJ"), is("Energy E = m c\u{b2} in kJ", 15));
    assert_eq!(said("$x_1^2$, $H_2O$"), is("x\u{2081}\u{b2}, H\u{2082}O", 7));
    assert_eq!(said(r"30 $\mu$g, 25$\,^\circ$C"), is("30 \u{3bc}g, 25\u{b0}C", 9));
    assert_eq!(said(r"$\times\mathdefault{10^{5}}\mathdefault{}$"), is("\u{d7}10\u{2075}", 4));
    assert_eq!(said(r"$2^n$, $e^{-x}$, $Na^+$, $v_\mathrm{max}$"), is("2^n , e^(\u{2212}x) , Na\u{207a}, v max", 15));
    assert_eq!(said(r"$\alpha \leq \Omega$ in \%"), None, "a backslash outside of formulas");
    assert_eq!(said(r"$\alpha \leq 5\%$"), is("\u{3b1}\u{2264}5%", 4));
}

#[test]
fn what_is_raised_in_a_formula_is_a_power() {
    let of = |text: &str| said(text).map(|(string, _)| string);
    assert_eq!(of("$2^m$").as_deref(), Some("2^m"));
    assert_eq!(of("$10^{1.5}$").as_deref(), Some("10^1.5"));
    assert_eq!(of("$e^{ix}$ $x^a$").as_deref(), Some("e^(ix) x^a"));
    assert_eq!(of("$x_1^n$").as_deref(), Some("x\u{2081}^n"));
    assert_eq!(of("$x_{10}^{a+b}$").as_deref(), Some("x\u{2081}\u{2080}^(a+b)"));
    assert_eq!(of(r"$1^\mathrm{st}$, $2^{nd}$").as_deref(), Some("1 st , 2 nd"), "ordinals");
    assert_eq!(of("$^a$ of 2019").as_deref(), Some("a of 2019"), "there is nothing of which it is one");
}

#[test]
fn what_is_not_known_is_no_formula() {
    for text in [r"$\frac{1}{2}$", r"$\sqrt{2}$", "$x'$", "$x}$", "${x$", "$x^$", r"$x\$", "$x__1$"] {
        assert_eq!(said(text), None, "{text}");
    }
    let deep = format!("${}x{}$", "{".repeat(500_000), "}".repeat(500_000));
    assert_eq!(said(&deep), None);
}

#[test]
fn a_formula_has_dollars_on_both_sides() {
    assert!(is_formula("$x$") && is_formula(r"a\b") && is_formula("5 $ and 6 $"));
    assert!(!is_formula("5 $") && !is_formula("5 m"));
}
