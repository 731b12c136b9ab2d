//! Pages: HTML files that need no other.

use crate::drawing;
use crate::table::BREAK;
use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = include_str!("style/pages.css");

/// A page with a title and a class that says how it is laid out.
pub(crate) fn page(title: &str, class: &str, body: &Markup) -> String {
    let page = html! {
        (DOCTYPE) (BREAK)
        html lang="en" { (BREAK)
            head { (BREAK)
                meta charset="utf-8"; (BREAK)
                meta name="viewport" content="width=device-width, initial-scale=1"; (BREAK)
                title { (title) } (BREAK)
                style { (BREAK) (PreEscaped(drawing::STYLE)) (PreEscaped(STYLE)) } (BREAK)
            } (BREAK)
            body class=(class) { (BREAK) (body) } (BREAK)
        } (BREAK)
    };
    page.into_string()
}
