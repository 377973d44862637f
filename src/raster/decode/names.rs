//! Names of letters and signs beyond Latin-1, in fonts; those of Greek letters are the same in formulas.

/// The letter of a name: `minus`, `ccaron`, `alpha`, `uni0416`.
pub(super) fn letter_named(name: &str) -> Option<char> {
    let is_hex = |hex: &&str| hex.len() == 4 && hex.bytes().all(|byte| byte.is_ascii_hexdigit());
    if let Some(hex) = name.strip_prefix("uni").filter(is_hex) {
        return u32::from_str_radix(hex, 16).ok().and_then(char::from_u32);
    }
    if let Some((_, sign)) = SIGNS.iter().find(|(own, _)| *own == name) {
        return Some(*sign);
    }
    let first = name.chars().next()?;
    let capital = format!("{}{}", first.to_ascii_uppercase(), &name[first.len_utf8()..]);
    let is_small = u32::from(first.is_ascii_lowercase());
    let latin = LATIN.iter().find(|(own, _)| *own == capital).map(|(_, code)| code + is_small);
    let greek = || (0x391..).zip(GREEK).find(|(_, own)| *own == capital).map(|(code, _)| code + 0x20 * is_small);
    latin.or_else(greek).and_then(char::from_u32)
}

const SIGNS: [(&str, char); 27] = [
    ("minus", '\u{2212}'),
    ("endash", '\u{2013}'),
    ("emdash", '\u{2014}'),
    ("quoteleft", '\u{2018}'),
    ("quoteright", '\u{2019}'),
    ("quotesinglbase", '\u{201a}'),
    ("quotedblleft", '\u{201c}'),
    ("quotedblright", '\u{201d}'),
    ("quotedblbase", '\u{201e}'),
    ("bullet", '\u{2022}'),
    ("ellipsis", '\u{2026}'),
    ("perthousand", '\u{2030}'),
    ("Euro", '\u{20ac}'),
    ("arrowleft", '\u{2190}'),
    ("arrowup", '\u{2191}'),
    ("arrowright", '\u{2192}'),
    ("arrowdown", '\u{2193}'),
    ("summation", '\u{2211}'),
    ("radical", '\u{221a}'),
    ("infinity", '\u{221e}'),
    ("approxequal", '\u{2248}'),
    ("notequal", '\u{2260}'),
    ("lessequal", '\u{2264}'),
    ("greaterequal", '\u{2265}'),
    ("dotlessi", '\u{131}'),
    ("OE", '\u{152}'),
    ("oe", '\u{153}'),
];

/// Capitals; each small letter comes next.
const LATIN: [(&str, u32); 33] = [
    ("Amacron", 0x100),
    ("Abreve", 0x102),
    ("Aogonek", 0x104),
    ("Cacute", 0x106),
    ("Ccaron", 0x10c),
    ("Dcaron", 0x10e),
    ("Dcroat", 0x110),
    ("Emacron", 0x112),
    ("Edotaccent", 0x116),
    ("Eogonek", 0x118),
    ("Ecaron", 0x11a),
    ("Gbreve", 0x11e),
    ("Imacron", 0x12a),
    ("Iogonek", 0x12e),
    ("Lacute", 0x139),
    ("Lcaron", 0x13d),
    ("Lslash", 0x141),
    ("Nacute", 0x143),
    ("Ncaron", 0x147),
    ("Ohungarumlaut", 0x150),
    ("Racute", 0x154),
    ("Rcaron", 0x158),
    ("Sacute", 0x15a),
    ("Scedilla", 0x15e),
    ("Scaron", 0x160),
    ("Tcaron", 0x164),
    ("Umacron", 0x16a),
    ("Uring", 0x16e),
    ("Uhungarumlaut", 0x170),
    ("Uogonek", 0x172),
    ("Zacute", 0x179),
    ("Zdotaccent", 0x17b),
    ("Zcaron", 0x17d),
];

/// In their order; each small letter is as far behind its capital. One place is empty: there are two forms of the small
/// sigma.
const GREEK: [&str; 25] = [
    "Alpha", "Beta", "Gamma", "Delta", "Epsilon", "Zeta", "Eta", "Theta", "Iota", "Kappa", "Lambda", "Mu", "Nu", "Xi",
    "Omicron", "Pi", "Rho", "Sigma1", "Sigma", "Tau", "Upsilon", "Phi", "Chi", "Psi", "Omega",
];

#[cfg(test)]
mod tests;
