//! Reading a table of a braille code.
//!
//! A line is a word and what belongs to it; lines that begin with `# ` are remarks. Cells are dots joined by hyphens:
//! `46-1` is a cell of dots 4 and 6 and one of dot 1, `0` is a blank.
//!
//! ```text
//! name Unified English Braille
//! word key Key                         a word of the key, in the language
//! number 3456                          digits follow
//! digits 245 1 12 14 145 15 124 1245 125 24    of 0 to 9
//! group 5                              between groups of digits; "thousands" behind it: of three digits only
//! address 6-46                         before an address of mail or of the net
//! continuation 5                       at the end of a line behind which an address goes on
//! in-address / 256                     characters of addresses with cells of their own, in pairs
//! letter-after-number 56               before a to j after digits; "any" behind it: before capitals too
//! superscript 34 356 2 23 25 256 26 235 2356 236 35    before raised numbers, and their digits 0 to 9 if these are
//!                                      not behind the sign of numbers; "subscript": the same of lowered numbers
//! superscript-minus 34-36              before negative ones; a second word stands after them
//! charge 56-35 5-235 5-36              before the sign of a charge alone, and the signs of plus and minus there
//! charges 56-35-126 345                before and after the number and the sign of a charge
//! formulas uncontracted                in contracted braille, too, as by this table
//! contracted ea sr                     letters that are words of the contracted code, without a sign before them
//! short-words of to                    words of the language that no abbreviation is to be
//! ordinal-digits 356 2 23 25 256 26 235 2356 236 35    of numbers of an order, such as 1.º
//! capital 6                            before one
//! capital-word 6-6
//! capital-end 6-3                      a word goes on in small letters
//! capital-through - .                  signs that capitals go through
//! capital-passage 3 6-6-6 6-3          from 3 words on; "before-last" behind it: the end stands before the last word
//! straight-quotes paired               single ones in pairs are those that open and close
//! letters a 1 b 12
//! sign . _# 3456-256 number            a sign, its neighbours, its cells, and what else it does
//! sign . ** 256
//! ```
//!
//! Neighbours are those on the left and on the right: `*` anything, `_` nothing or a space, `a` a letter, `#` a digit,
//! `n` a space with a digit beyond it, `%` (on the left) a sign of percent, degrees, powers or fractions. The first
//! line that fits counts. What else a sign does: `number`, digits that follow belong to the same number; `<`, `>`: the
//! space on that side falls out.

use std::collections::BTreeMap;

use super::table::{AfterNumber, CapitalPassage, Capitals, Group, Ordinals, Script, SignRule, Table};

/// A table, or what is wrong with its text and on which line.
pub(super) fn table(text: &str) -> Result<Table, String> {
    let mut table = Table::default();
    for (number, line) in (1..).zip(text.lines()) {
        read(line, &mut table).map_err(|what| format!("line {number}: {what}"))?;
    }
    if table.digits.len() != 10 || table.number.is_empty() || table.letters.is_empty() {
        return Err("number, digits or letters are missing".into());
    }
    Ok(table)
}

fn read(line: &str, table: &mut Table) -> Result<(), String> {
    if line.trim().is_empty() || line.starts_with("# ") {
        return Ok(());
    }
    let (word, rest) = line.split_once(' ').ok_or("a word alone")?;
    let parts: Vec<&str> = rest.split_whitespace().collect();
    let part = |i: usize| parts.get(i).copied().ok_or_else(|| format!("{word} lacks something"));
    let capitals = |table: &mut Table, put: &dyn Fn(&mut Capitals)| put(table.capitals.get_or_insert_default());
    match word {
        "name" => rest.clone_into(&mut table.name),
        "word" => {
            table.words.insert(part(0)?.to_owned(), part(1)?.to_owned());
        }
        "number" => table.number = cells(part(0)?)?,
        "digits" => table.digits = ten(&parts)?,
        "group" => {
            let of_thousands_only = parts.get(1) == Some(&"thousands");
            table.group = Some(Group { cells: cells(part(0)?)?, of_thousands_only });
        }
        "address" => table.address = Some(cells(part(0)?)?),
        "letter-after-number" => {
            let before_capitals = parts.get(1) == Some(&"any");
            table.letter_after_number = Some(AfterNumber { sign: cells(part(0)?)?, before_capitals });
        }
        "capital" => {
            let cells = cells(part(0)?)?;
            capitals(table, &|capitals| capitals.letter.clone_from(&cells));
        }
        "capital-word" => {
            let cells = cells(part(0)?)?;
            capitals(table, &|capitals| capitals.word.clone_from(&cells));
        }
        "capital-end" => {
            let cells = cells(part(0)?)?;
            capitals(table, &|capitals| capitals.end = Some(cells.clone()));
        }
        "capital-through" => {
            let through: Vec<char> = parts.iter().filter_map(|part| part.chars().next()).collect();
            capitals(table, &|capitals| capitals.through.clone_from(&through));
        }
        "capital-passage" => {
            let words = part(0)?.parse().map_err(|_| "no number of words")?;
            let before_last = parts.get(3) == Some(&"before-last");
            let passage = CapitalPassage { words, begin: cells(part(1)?)?, end: cells(part(2)?)?, before_last };
            capitals(table, &|capitals| capitals.passage = Some(passage.clone()));
        }
        "continuation" => table.continuation = Some(cell(part(0)?)?),
        "straight-quotes" => table.pairs_straight_quotes = part(0)? == "paired",
        "in-address" => pairs(&parts, &mut table.in_address)?,
        "letters" => pairs(&parts, &mut table.letters)?,
        "sign" => {
            let rule = rule(part(1)?, part(2)?, parts.get(3..).unwrap_or_default())?;
            let sign = part(0)?;
            table.longest = table.longest.max(sign.chars().count());
            table.signs.entry(sign.to_owned()).or_default().push(rule);
        }
        _ => return read_numbers(word, &parts, table),
    }
    Ok(())
}

/// The words of numbers that stand higher or lower, or are of an order, and of contracted braille.
fn read_numbers(word: &str, parts: &[&str], table: &mut Table) -> Result<(), String> {
    match (word, parts) {
        ("superscript", _) => script(&mut table.superscript, parts)?,
        ("subscript", _) => script(&mut table.subscript, parts)?,
        ("superscript-minus", [before, after @ ..]) => {
            let after = after.first().map_or(Ok(Vec::new()), |dots| cells(dots))?;
            table.superscript.get_or_insert_default().minus = Some((cells(before)?, after));
        }
        ("charge", [before, plus, minus]) => {
            let charges = table.charges.get_or_insert_default();
            (charges.before_one, charges.plus, charges.minus) = (cells(before)?, cells(plus)?, cells(minus)?);
        }
        ("charges", [before, after]) => {
            let charges = table.charges.get_or_insert_default();
            (charges.before, charges.after) = (cells(before)?, cells(after)?);
        }
        ("formulas", ["uncontracted"]) => table.formulas_are_uncontracted = true,
        ("contracted", words) => table.contracted.extend(words.iter().map(|&word| word.to_owned())),
        ("short-words", words) => table.short_words.extend(words.iter().map(|&word| word.to_owned())),
        ("ordinal-digits", _) => table.ordinals = Some(Ordinals { digits: ten(parts)? }),
        _ => return Err(format!("no such word as {word}")),
    }
    Ok(())
}

/// Characters, each with its cells.
fn pairs(parts: &[&str], to: &mut BTreeMap<char, Vec<u8>>) -> Result<(), String> {
    for pair in parts.chunks(2) {
        let [letter, dots] = pair else { return Err("a letter without dots".into()) };
        to.insert(letter.chars().next().ok_or("no letter")?, cells(dots)?);
    }
    Ok(())
}

/// How a sign is written between its two neighbours, and what else it does.
fn rule(neighbours: &str, dots: &str, flags: &[&str]) -> Result<SignRule, String> {
    let mut sides = neighbours.chars();
    let (left, right) = sides.next().zip(sides.next()).ok_or("a sign without neighbours")?;
    if let Some(flag) = flags.iter().find(|flag| !["number", "<", ">"].contains(flag)) {
        return Err(format!("no such thing as {flag}"));
    }
    let has = |flag| flags.contains(&flag);
    let (in_number, joins_left, joins_right) = (has("number"), has("<"), has(">"));
    Ok(SignRule { left, right, cells: cells(dots)?, in_number, joins_left, joins_right })
}

/// How raised or lowered numbers are written: what stands before them, and their digits.
fn script(script: &mut Option<Script>, parts: &[&str]) -> Result<(), String> {
    let (before, digits) = parts.split_first().ok_or("no cells")?;
    let script = script.get_or_insert_default();
    script.before = cells(before)?;
    script.digits = if digits.is_empty() { Vec::new() } else { ten(digits)? };
    Ok(())
}

/// The cells of ten digits.
fn ten(digits: &[&str]) -> Result<Vec<u8>, String> {
    let cells = digits.iter().map(|dots| cell(dots)).collect::<Result<Vec<_>, _>>()?;
    if cells.len() == 10 { Ok(cells) } else { Err(format!("{} digits", cells.len())) }
}

fn cells(text: &str) -> Result<Vec<u8>, String> {
    text.split('-').map(cell).collect()
}

/// A cell from the numbers of its dots; `0` is a blank.
fn cell(dots: &str) -> Result<u8, String> {
    if dots == "0" {
        return Ok(0);
    }
    let bit = |dot: char| dot.to_digit(7).filter(|&dot| dot > 0).map(|dot| 1_u8 << (dot - 1));
    let bits = dots.chars().map(|dot| bit(dot).ok_or_else(|| format!("no dots: {dots}")));
    bits.into_iter().try_fold(0, |cell, bit| Ok(cell | bit?))
}

#[cfg(test)]
mod tests;
