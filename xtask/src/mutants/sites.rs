//! The places of a source file at which its code can be made wrong, and the text that does it behind a switch.

use std::ops::Range;

use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, ExprBinary, ExprLit, ExprMethodCall, ExprUnary, Lit, Stmt, UnOp};

/// One change of the code.
#[derive(Debug, Clone)]
pub(super) struct Site {
    /// Bytes of the file that are replaced.
    pub(super) bytes: Range<usize>,
    pub(super) line: usize,
    /// What is changed, for a person.
    pub(super) what: String,
    /// The text in place of these bytes.
    pub(super) wrong: String,
    /// A statement that is left out, and no value.
    statement: bool,
}

impl Site {
    /// Both texts, of which a switch chooses one: `mutant` is its number.
    pub(super) fn switched(&self, source: &str, mutant: usize) -> String {
        let right = &source[self.bytes.clone()];
        if self.statement {
            format!("if !crate::mutated({mutant}) {{ {right} }}")
        } else {
            format!("(if crate::mutated({mutant}) {{ {} }} else {{ {right} }})", self.wrong)
        }
    }
}

/// All sites of a file, in its order. Constants, patterns, types, macros and tests have none: a switch cannot stand there.
pub(super) fn of(source: &str) -> syn::Result<Vec<Site>> {
    let mut found = Found { source, sites: Vec::new() };
    found.visit_file(&syn::parse_file(source)?);
    Ok(found.sites)
}

struct Found<'a> {
    source: &'a str,
    sites: Vec<Site>,
}

impl Found<'_> {
    fn text(&self, span: Span) -> &str {
        &self.source[span.byte_range()]
    }

    fn add(&mut self, span: Span, what: String, wrong: String) {
        self.sites.push(Site { bytes: span.byte_range(), line: span.start().line, what, wrong, statement: false });
    }
}

/// The operator that stands for another one in a mutant.
fn other(operator: &BinOp) -> Option<&'static str> {
    Some(match operator {
        BinOp::Lt(_) => "<=",
        BinOp::Le(_) => "<",
        BinOp::Gt(_) => ">=",
        BinOp::Ge(_) => ">",
        BinOp::Eq(_) => "!=",
        BinOp::Ne(_) => "==",
        BinOp::And(_) => "||",
        BinOp::Or(_) => "&&",
        BinOp::Add(_) => "-",
        BinOp::Sub(_) => "+",
        BinOp::Mul(_) => "/",
        BinOp::Div(_) => "*",
        BinOp::AddAssign(_) => "-=",
        BinOp::SubAssign(_) => "+=",
        BinOp::MulAssign(_) => "/=",
        BinOp::DivAssign(_) => "*=",
        _ => return None,
    })
}

/// The method that stands for another one.
fn opposite(method: &str) -> Option<&'static str> {
    const PAIRS: [[&str; 2]; 8] = [
        ["min", "max"],
        ["any", "all"],
        ["is_some", "is_none"],
        ["is_ok", "is_err"],
        ["first", "last"],
        ["floor", "ceil"],
        ["min_by", "max_by"],
        ["take_while", "skip_while"],
    ];
    PAIRS.iter().find_map(|[a, b]| if method == *a { Some(*b) } else { (method == *b).then_some(*a) })
}

/// `let` in a condition: it cannot move into a block of its own.
fn binds(expression: &Expr) -> bool {
    match expression {
        Expr::Let(_) => true,
        Expr::Binary(both) => binds(&both.left) || binds(&both.right),
        _ => false,
    }
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|a| a.path().is_ident("test") || a.path().is_ident("cfg"))
}

impl<'ast> Visit<'ast> for Found<'_> {
    fn visit_item_const(&mut self, _: &'ast syn::ItemConst) {}
    fn visit_item_static(&mut self, _: &'ast syn::ItemStatic) {}
    fn visit_impl_item_const(&mut self, _: &'ast syn::ImplItemConst) {}
    fn visit_item_enum(&mut self, _: &'ast syn::ItemEnum) {}
    fn visit_type(&mut self, _: &'ast syn::Type) {}
    fn visit_pat(&mut self, _: &'ast syn::Pat) {}
    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}
    fn visit_generic_argument(&mut self, _: &'ast syn::GenericArgument) {}

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_test(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        if item.sig.constness.is_none() && !is_test(&item.attrs) {
            visit::visit_item_fn(self, item);
        }
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if item.sig.constness.is_none() {
            visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_expr_repeat(&mut self, expression: &'ast syn::ExprRepeat) {
        self.visit_expr(&expression.expr);
    }

    fn visit_expr_const(&mut self, _: &'ast syn::ExprConst) {}

    fn visit_stmt(&mut self, statement: &'ast Stmt) {
        if let Stmt::Expr(Expr::MethodCall(_) | Expr::Call(_), Some(_)) = statement {
            let span = statement.span();
            let what = format!("without `{}`", self.text(span));
            let line = span.start().line;
            self.sites.push(Site { bytes: span.byte_range(), line, what, wrong: String::new(), statement: true });
        }
        visit::visit_stmt(self, statement);
    }

    fn visit_expr_binary(&mut self, both: &'ast ExprBinary) {
        if let Some(operator) = other(&both.op).filter(|_| !binds(&both.left) && !binds(&both.right)) {
            let [left, right] = [&both.left, &both.right].map(|side| self.text(side.span()).to_owned());
            let assigns =
                operator.len() == 2 && operator.ends_with('=') && !matches!(operator, "<=" | ">=" | "==" | "!=");
            // The tree stays as it is: `a || b && c` made of `a && b && c` is `(a || b) && c`.
            let wrong =
                if assigns { format!("{left} {operator} {right}") } else { format!("({left}) {operator} ({right})") };
            let before = self.text(both.op.span()).to_owned();
            self.add(both.span(), format!("`{before}` for `{operator}`"), wrong);
        }
        visit::visit_expr_binary(self, both);
    }

    fn visit_expr_unary(&mut self, one: &'ast ExprUnary) {
        if matches!(one.op, UnOp::Neg(_) | UnOp::Not(_)) {
            let (sign, rest) = (self.text(one.op.span()).to_owned(), self.text(one.expr.span()).to_owned());
            self.add(one.span(), format!("`{sign}` left out"), rest);
        }
        visit::visit_expr_unary(self, one);
    }

    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        if let Some(method) = opposite(&call.method.to_string()) {
            let (whole, name) = (call.span().byte_range(), call.method.span().byte_range());
            let wrong =
                format!("{}{method}{}", &self.source[whole.start..name.start], &self.source[name.end..whole.end]);
            self.add(call.span(), format!("`{}` for `{method}`", call.method), wrong);
        }
        visit::visit_expr_method_call(self, call);
    }

    fn visit_expr_lit(&mut self, literal: &'ast ExprLit) {
        match &literal.lit {
            Lit::Bool(value) => {
                self.add(
                    literal.span(),
                    format!("`{}` for `{}`", value.value, !value.value),
                    (!value.value).to_string(),
                );
            }
            Lit::Float(value) if value.base10_parse::<f64>().is_ok_and(|v| v != 0.0) => {
                self.add(literal.span(), format!("`{value}` by one per cent"), format!("{value} * 1.01"));
            }
            _ => {}
        }
    }
}
