// The state of the page as the fragment of its address, which no server sees.

const LONGEST = 400_000;

/** Puts a state into the address. */
export function writeLink(state) {
  const text = btoa(unescape(encodeURIComponent(JSON.stringify(state))));
  if (text.length > LONGEST) {
    throw new Error("This is too much for a link: save the points as a file.");
  }
  history.replaceState(null, "", `#${text.replaceAll("+", "-").replaceAll("/", "_")}`);
}

/** The state in the address, or null if there is none that can be read. */
export function readLink() {
  try {
    const text = location.hash.slice(1).replaceAll("-", "+").replaceAll("_", "/");
    const state = text ? JSON.parse(decodeURIComponent(escape(atob(text)))) : null;
    return state && typeof state === "object" ? state : null;
  } catch {
    return null;
  }
}
