//! Where a source file can be changed so that it does something else and is still compiled.
//!
//! Every change is written around what is there, and a number decides at run time which of the two is done:
//! `(if crate::mutant(7) { a - b } else { (a + b) })`.

use std::ops::Range;

use proc_macro2::Span;
use quote::ToTokens;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, ReturnType, Stmt, Type, UnOp};

/// A place, and the ways in which it can be changed.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    /// What stays, in bytes of the file; the change is written before and after it.
    pub(crate) range: Range<usize>,
    /// Its first and last line, from 1.
    pub(crate) lines: (usize, usize),
    pub(crate) ways: Vec<Way>,
}

/// One way to change a place.
#[derive(Debug, Clone)]
pub(crate) struct Way {
    /// What it does, for people.
    pub(crate) told: String,
    /// What is written before and after; `MUTANT` stands for the question whether it is on.
    pub(crate) around: [String; 2],
}

/// All places of a file.
///
/// # Errors
/// It is not Rust.
pub(crate) fn places(text: &str) -> syn::Result<Vec<Place>> {
    let mut finder = Finder { places: Vec::new() };
    finder.visit_file(&syn::parse_file(text)?);
    Ok(finder.places)
}

struct Finder {
    places: Vec<Place>,
}

impl Finder {
    fn add(&mut self, span: Span, ways: Vec<Way>) {
        let lines = (span.start().line, span.end().line);
        if !ways.is_empty() {
            self.places.push(Place { range: span.byte_range(), lines, ways });
        }
    }

    fn function(&mut self, returns: &ReturnType, block: &syn::Block) {
        let open = block.brace_token.span.open();
        let values: &[&str] = match returns {
            ReturnType::Default => &[""],
            ReturnType::Type(_, returned) => values(returned),
        };
        let way = |value: &&str| Way {
            told: format!("the function returns at once: {value}"),
            around: [format!("if MUTANT {{ return {value}; }}"), String::new()],
        };
        // a function of nothing but a call would be changed by leaving out that call
        if block.stmts.len() > 1 || !matches!(returns, ReturnType::Default) {
            let lines = (open.end().line, open.end().line);
            let at = open.byte_range().end;
            let ways: Vec<Way> = values.iter().map(way).collect();
            if !ways.is_empty() {
                self.places.push(Place { range: at..at, lines, ways });
            }
        }
        visit::visit_block(self, block);
    }
}

/// What a function of this type could return whatever it is given.
fn values(returned: &Type) -> &'static [&'static str] {
    let Type::Path(path) = returned else { return &[] };
    let name = path.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
    match name.as_str() {
        "bool" => &["true", "false"],
        "f32" | "f64" => &["0.0", "1.0"],
        "usize" | "u8" | "u16" | "u32" | "u64" | "i32" | "i64" => &["0", "1"],
        "Option" => &["None"],
        "Vec" => &["Vec::new()"],
        _ => &[],
    }
}

/// Done in place of what is there.
fn instead(told: String, other: &str) -> Way {
    Way { told, around: [format!("(if MUTANT {{ {other} }} else {{ ("), ") })".into()] }
}

fn operators(left: &Expr, op: &BinOp, right: &Expr) -> Vec<Way> {
    let is_counted = [left, right].iter().any(|side| is_counted(side));
    let others: &[&str] = match op {
        BinOp::Add(_) => &["-"],
        BinOp::Sub(_) => &["+"],
        BinOp::Mul(_) => &["/"],
        BinOp::Div(_) | BinOp::Rem(_) => &["*"],
        BinOp::And(_) => &["||"],
        BinOp::Or(_) => &["&&"],
        BinOp::BitAnd(_) | BinOp::BitXor(_) => &["|"],
        BinOp::BitOr(_) => &["&"],
        BinOp::Shl(_) => &[">>"],
        BinOp::Shr(_) => &["<<"],
        BinOp::Eq(_) => &["!="],
        BinOp::Ne(_) => &["=="],
        // where a limit is belongs to the question only where numbers are counted: measures are equal by chance
        BinOp::Lt(_) if is_counted => &[">=", "<="],
        BinOp::Le(_) if is_counted => &[">", "<"],
        BinOp::Gt(_) if is_counted => &["<=", ">="],
        BinOp::Ge(_) if is_counted => &["<", ">"],
        BinOp::Lt(_) => &[">="],
        BinOp::Le(_) => &[">"],
        BinOp::Gt(_) => &["<="],
        BinOp::Ge(_) => &["<"],
        BinOp::AddAssign(_) => &["-="],
        BinOp::SubAssign(_) => &["+="],
        BinOp::MulAssign(_) => &["/="],
        BinOp::DivAssign(_) | BinOp::RemAssign(_) => &["*="],
        BinOp::BitOrAssign(_) => &["&="],
        BinOp::BitAndAssign(_) => &["|="],
        _ => &[],
    };
    let is_assignment = |other: &str| other.ends_with('=') && !["<=", ">=", "==", "!="].contains(&other);
    let (left, right, op) = (left.to_token_stream(), right.to_token_stream(), op.to_token_stream());
    let way = |other: &&str| {
        let left = if is_assignment(other) { left.to_string() } else { format!("({left})") };
        instead(format!("`{op}` is `{other}`"), &format!("{left} {other} ({right})"))
    };
    others.iter().map(way).collect()
}

/// Whether an operand is a whole number as written, or a number of things.
fn is_counted(side: &Expr) -> bool {
    match side {
        Expr::Lit(literal) => matches!(literal.lit, syn::Lit::Int(_)),
        Expr::MethodCall(call) => ["len", "count"].iter().any(|name| call.method == name),
        _ => false,
    }
}

/// Methods of which one does what the other does not.
const OPPOSITE_METHODS: [(&str, &str); 7] = [
    ("min", "max"),
    ("any", "all"),
    ("is_some", "is_none"),
    ("is_some_and", "is_none_or"),
    ("first", "last"),
    ("min_by", "max_by"),
    ("floor", "ceil"),
];

fn opposite(method: &str) -> Option<&'static str> {
    let other = |(a, b): &(&'static str, &'static str)| match method {
        _ if method == *a => Some(*b),
        _ if method == *b => Some(*a),
        _ => None,
    };
    OPPOSITE_METHODS.iter().find_map(other)
}

/// Whether names are bound in a condition, which has to stay one chain.
fn binds(condition: &Expr) -> bool {
    match condition {
        Expr::Let(_) => true,
        Expr::Binary(binary) if matches!(binary.op, BinOp::And(_)) => binds(&binary.left) || binds(&binary.right),
        _ => false,
    }
}

/// Whether something is there for tests only.
fn is_for_tests(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let text = attribute.to_token_stream().to_string();
        attribute.path().is_ident("test") || attribute.path().is_ident("cfg") && text.contains("test")
    })
}

impl<'ast> Visit<'ast> for Finder {
    fn visit_expr_binary(&mut self, binary: &'ast syn::ExprBinary) {
        if !(binds(&binary.left) || binds(&binary.right)) {
            self.add(binary.span(), operators(&binary.left, &binary.op, &binary.right));
        }
        visit::visit_expr_binary(self, binary);
    }

    fn visit_expr_unary(&mut self, unary: &'ast syn::ExprUnary) {
        if matches!(unary.op, UnOp::Not(_) | UnOp::Neg(_)) {
            let (op, operand) = (unary.op.to_token_stream(), unary.expr.to_token_stream().to_string());
            self.add(unary.span(), vec![instead(format!("`{op}` is left out"), &operand)]);
        }
        visit::visit_expr_unary(self, unary);
    }

    fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
        let method = call.method.to_string();
        if let Some(other) = opposite(&method) {
            let mut changed = call.clone();
            changed.method = syn::Ident::new(other, Span::call_site());
            let changed = changed.to_token_stream().to_string();
            self.add(call.span(), vec![instead(format!("`{method}` is `{other}`"), &changed)]);
        }
        if let (true, Some(Expr::Closure(closure))) = (method == "filter", call.args.first()) {
            let around = ["(MUTANT || (".into(), "))".into()];
            self.add(closure.body.span(), vec![Way { told: "`filter` keeps all".into(), around }]);
        }
        visit::visit_expr_method_call(self, call);
    }

    fn visit_arm(&mut self, arm: &'ast syn::Arm) {
        if let Some((_, guard)) = arm.guard.as_ref().filter(|(_, guard)| !binds(guard)) {
            let always = ["(MUTANT || (".into(), "))".into()];
            let never = ["(!MUTANT && (".into(), "))".into()];
            let way = |told: &str, around| Way { told: format!("a guard is {told}"), around };
            self.add(guard.span(), vec![way("true", always), way("false", never)]);
        }
        visit::visit_arm(self, arm);
    }

    fn visit_stmt(&mut self, statement: &'ast Stmt) {
        if let Stmt::Expr(Expr::MethodCall(_) | Expr::Call(_), Some(_)) = statement {
            let around = ["if !MUTANT { ".into(), " }".into()];
            self.add(statement.span(), vec![Way { told: "a call is left out".into(), around }]);
        }
        visit::visit_stmt(self, statement);
    }

    fn visit_item_fn(&mut self, function: &'ast syn::ItemFn) {
        if function.sig.constness.is_none() && !is_for_tests(&function.attrs) {
            self.function(&function.sig.output, &function.block);
        }
    }

    fn visit_impl_item_fn(&mut self, function: &'ast syn::ImplItemFn) {
        if function.sig.constness.is_none() && !is_for_tests(&function.attrs) {
            self.function(&function.sig.output, &function.block);
        }
    }

    fn visit_item_mod(&mut self, module: &'ast syn::ItemMod) {
        if !is_for_tests(&module.attrs) {
            visit::visit_item_mod(self, module);
        }
    }

    fn visit_item_impl(&mut self, implementation: &'ast syn::ItemImpl) {
        if !is_for_tests(&implementation.attrs) {
            visit::visit_item_impl(self, implementation);
        }
    }

    // What the compiler works out, and what is no expression.
    fn visit_expr_repeat(&mut self, repeat: &'ast syn::ExprRepeat) {
        self.visit_expr(&repeat.expr);
    }
    fn visit_item_const(&mut self, _: &'ast syn::ItemConst) {}
    fn visit_item_static(&mut self, _: &'ast syn::ItemStatic) {}
    fn visit_impl_item_const(&mut self, _: &'ast syn::ImplItemConst) {}
    fn visit_trait_item_const(&mut self, _: &'ast syn::TraitItemConst) {}
    fn visit_item_enum(&mut self, _: &'ast syn::ItemEnum) {}
    fn visit_expr_const(&mut self, _: &'ast syn::ExprConst) {}
    fn visit_type(&mut self, _: &'ast Type) {}
    fn visit_generic_argument(&mut self, _: &'ast syn::GenericArgument) {}
    fn visit_pat(&mut self, _: &'ast syn::Pat) {}
    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file with the first way of each of its places.
    fn changed(text: &str) -> Vec<String> {
        let places = places(text).expect("it is Rust");
        let changed = |place: &Place| {
            let Place { range, ways, .. } = place;
            let [before, after] = &ways[0].around;
            [&text[..range.start], before, &text[range.clone()], after, &text[range.end..]].concat()
        };
        places.iter().map(changed).collect()
    }

    #[test]
    fn an_operator_is_changed_where_it_stands() {
        let [changed] = &changed("fn f(a: P) -> P { a + B }")[..] else { panic!("one place") };
        assert_eq!(changed, "fn f(a: P) -> P { (if MUTANT { (a) - (B) } else { (a + B) }) }");
    }

    #[test]
    fn constants_patterns_tests_and_chains_that_bind_stay() {
        for text in [
            "const A: u8 = 1 + 2;",
            "#[cfg(test)] mod tests { fn f() -> bool { 1 < 2 } }",
            "const fn f() -> bool { 1 < 2 }",
            "fn f(a: [u8; 1 + 2]) -> P { if let -1 = a && let 2 = b { c } else { d } }",
        ] {
            assert_eq!(changed(text), [""; 0], "{text}");
        }
    }

    #[test]
    fn every_place_is_still_rust() {
        let text = "fn f(a: &mut A) -> bool {
            // a limit, à peu près
            a.push(-1); a.b += c as u8;
            match a { x if x.len() < 3 => !x, _ => a.iter().filter(|b| b.d).any(|b| b.e && c) }
        }";
        let changed = changed(text);
        assert_eq!(changed.len(), 10, "{changed:#?}");
        changed.iter().for_each(|text| drop(syn::parse_file(&text.replace("MUTANT", "m")).expect("it is Rust")));
    }
}
