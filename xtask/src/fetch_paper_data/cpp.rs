//! String variables of C++ sources: just enough of the language to find them.

use std::iter::Peekable;
use std::str::Chars;

#[derive(Debug, PartialEq, Eq)]
enum Token {
    Word(String),
    Text(String),
    Mark(char),
}

/// The distinct string literals that initialise variables called `name`, in order of appearance.
///
/// Knows `string name = "..."`, `char name[] = "..."`, `string name("...")` and the like; adjacent
/// literals are one.
pub(super) fn strings(source: &str, name: &str) -> Vec<String> {
    let tokens = tokens(source);
    let mut found = Vec::new();
    for (i, token) in tokens.iter().enumerate() {
        if matches!(token, Token::Word(word) if word == name)
            && let Some(text) = initialiser(&tokens[i + 1..])
            && !found.contains(&text)
        {
            found.push(text);
        }
    }
    found
}

/// The string literal that the tokens after the name of a variable give it.
fn initialiser(mut tokens: &[Token]) -> Option<String> {
    if let [Token::Mark('['), rest @ ..] = tokens {
        let end = rest.iter().position(|t| *t == Token::Mark(']'))?;
        tokens = &rest[end + 1..];
    }
    let [Token::Mark('=' | '(' | '{'), rest @ ..] = tokens else {
        return None;
    };
    let wrapper = |t: &Token| match t {
        Token::Word(word) => word == "std" || word == "string",
        Token::Mark(mark) => matches!(mark, ':' | '(' | '{'),
        Token::Text(_) => false,
    };
    let literals = rest.iter().skip_while(|t| wrapper(t));
    let parts: Vec<&str> = literals
        .map_while(|t| match t {
            Token::Text(text) => Some(text.as_str()),
            _ => None,
        })
        .collect();
    (!parts.is_empty()).then(|| parts.concat())
}

fn tokens(source: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut chars = source.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '/' if chars.peek() == Some(&'/') => {
                chars.by_ref().find(|&c| c == '\n');
            }
            '/' if chars.next_if_eq(&'*').is_some() => skip_comment(&mut chars),
            '"' => tokens.push(Token::Text(text(&mut chars))),
            '\'' => skip_character(&mut chars),
            c if is_word(c) => {
                let mut word = String::from(c);
                while let Some(c) = chars.next_if(|&c| is_word(c)) {
                    word.push(c);
                }
                tokens.push(Token::Word(word));
            }
            c if c.is_whitespace() => {}
            c => tokens.push(Token::Mark(c)),
        }
    }
    tokens
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Goes on behind the `*/`.
fn skip_comment(chars: &mut Peekable<Chars<'_>>) {
    while let Some(c) = chars.next() {
        if c == '*' && chars.next_if_eq(&'/').is_some() {
            return;
        }
    }
}

/// Goes on behind a character literal, if one begins here; a quote may also group digits.
fn skip_character(chars: &mut Peekable<Chars<'_>>) {
    let mut ahead = chars.clone();
    if ahead.next() == Some('\\') {
        ahead.next();
    }
    if ahead.next() == Some('\'') {
        *chars = ahead;
    }
}

/// The rest of a string literal behind its opening quote.
fn text(chars: &mut Peekable<Chars<'_>>) -> String {
    let mut text = String::new();
    while let Some(c) = chars.next() {
        match c {
            '"' => break,
            '\\' => match chars.next() {
                // A backslash before the end of a line joins it with the next one.
                Some('\n') | None => {}
                Some('\r') => {
                    chars.next_if_eq(&'\n');
                }
                Some('n') => text.push('\n'),
                Some('t') => text.push('\t'),
                Some(other) => text.push(other),
            },
            c => text.push(c),
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ways_to_initialise_a_string() {
        for source in [
            r#"string cat = "m 0,0";"#,
            r#"const char *cat = "m " "0,0";"#,
            "std::string cat =\n\t\"m \"\n\t// by parts\n\t\"0,\" /* \"9\" */ \"0\";",
            r#"static const char cat[] = { "m 0,0" };"#,
            r#"string cat("m 0,0"), dog("m 1,1");"#,
            r#"auto cat = std::string("m 0,0");"#,
            "char cat[6] = \"m \\\n0,0\";",
            "char cat[6] = \"m \\\r\n0,0\";",
        ] {
            assert_eq!(strings(source, "cat"), ["m 0,0"], "{source}");
        }
    }

    #[test]
    fn other_uses_of_the_name_are_no_initialisers() {
        for source in [
            r#"// string cat = "m 0,0";"#,
            r#"/* string cat = "m 0,0"; **/"#,
            r#"string tomcat = "m 0,0", cats = "m 0,0";"#,
            r#"if (cat == "m 0,0") print("cat = ", cat);"#,
            r#"print("string cat = \"m 0,0\"");"#,
            "string cat;",
            "string cat = read(path);",
            "string cat[",
            "string cat = ",
        ] {
            assert_eq!(strings(source, "cat"), [""; 0], "{source}");
        }
    }

    #[test]
    fn quotes_of_characters_open_no_string() {
        let source = r#"char q = '"', b = '\'', s = '\\'; int n = 1'000; string cat = "m 0,0";"#;
        assert_eq!(strings(source, "cat"), ["m 0,0"]);
    }

    #[test]
    fn equal_strings_count_once() {
        let source = r#"string cat = "a"; string cat = "b"; string cat = "a";"#;
        assert_eq!(strings(source, "cat"), ["a", "b"]);
    }
}
