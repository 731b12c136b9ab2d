//! What style says of an element: whether it is displayed, visible, and painted.
//!
//! Declarations count as in CSS: attributes first, then the rules of style sheets by their
//! specificity, then the `style` attribute; each replaces those before it, but for those that are
//! `!important`.

use roxmltree::{Document, Node};
use simplecss::{
    AttributeOperator, Declaration, DeclarationTokenizer, Element, PseudoClass, StyleSheet,
};

/// What style says of an element by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Style {
    pub(super) is_displayed: bool,
    /// `None`: as its parent.
    pub(super) is_visible: Option<bool>,
    /// Whether its inside and its outline are painted, not `none`; `None`: as its parent.
    pub(super) paints: [Option<bool>; 2],
}

/// The properties that count.
const PROPERTIES: [&str; 4] = ["display", "visibility", "fill", "stroke"];

/// The style sheets of a document.
pub(super) struct Sheets<'a>(StyleSheet<'a>);

impl<'a> Sheets<'a> {
    pub(super) fn of(document: &'a Document<'_>) -> Self {
        let mut sheet = StyleSheet::new();
        for node in document.descendants().filter(|n| n.has_tag_name("style")) {
            if matches!(node.attribute("type"), None | Some("" | "text/css")) {
                sheet.parse_more(node.text().unwrap_or_default());
            }
        }
        // Rules without a declaration that counts here need not be compared with elements.
        sheet.rules.retain(|rule| {
            let mut declarations = rule.declarations.iter();
            declarations.any(|d| PROPERTIES.contains(&d.name))
        });
        Self(sheet)
    }

    pub(super) fn of_element(&self, node: Node<'_, '_>) -> Style {
        let mut properties = PROPERTIES.map(|name| Property::of(name, node));
        let rules = self.0.rules.iter();
        let rules = rules.filter(|rule| rule.selector.matches(&Styled(node)));
        let of_sheets = rules.flat_map(|rule| rule.declarations.iter().copied());
        let own = DeclarationTokenizer::from(node.attribute("style").unwrap_or_default());
        for declaration in of_sheets.chain(own) {
            for property in &mut properties {
                property.declare(declaration);
            }
        }
        let [display, visibility, fill, stroke] = properties.map(|property| property.value);
        let paint = |value| match value {
            None | Some("inherit") => None,
            value => Some(value != Some("none")),
        };
        Style {
            is_displayed: display != Some("none"),
            is_visible: match visibility {
                Some("visible") => Some(true),
                Some("hidden" | "collapse") => Some(false),
                _ => None,
            },
            paints: [fill, stroke].map(paint),
        }
    }
}

/// A property, as far as declared.
struct Property<'a> {
    name: &'static str,
    value: Option<&'a str>,
    is_important: bool,
}

impl<'a> Property<'a> {
    fn of(name: &'static str, node: Node<'a, '_>) -> Self {
        Self {
            name,
            value: node.attribute(name).map(str::trim),
            is_important: false,
        }
    }

    fn declare(&mut self, declaration: Declaration<'a>) {
        if declaration.name == self.name && (declaration.important || !self.is_important) {
            self.value = Some(declaration.value.trim());
            self.is_important = declaration.important;
        }
    }
}

/// An element as selectors see it.
struct Styled<'a, 'input>(Node<'a, 'input>);

impl Element for Styled<'_, '_> {
    fn parent_element(&self) -> Option<Self> {
        self.0.parent_element().map(Self)
    }

    fn prev_sibling_element(&self) -> Option<Self> {
        self.0.prev_sibling_element().map(Self)
    }

    fn has_local_name(&self, name: &str) -> bool {
        self.0.tag_name().name() == name
    }

    fn attribute_matches(&self, name: &str, operator: AttributeOperator<'_>) -> bool {
        let value = self.0.attribute(name);
        value.is_some_and(|value| operator.matches(value))
    }

    fn pseudo_class_matches(&self, class: PseudoClass<'_>) -> bool {
        // A drawing on paper has no links, and nothing hovers over it.
        matches!(class, PseudoClass::FirstChild) && self.prev_sibling_element().is_none()
    }
}
