//! `report.html` in a browser: both colour schemes, at the width of a phone and of a desk. Without a
//! browser this says so and passes.

#![allow(clippy::unwrap_used)] // a test may

mod report_support;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crossfibre_verification::report::html;
use serde_json::Value;

/// The browser that the variable names, or the first that is installed.
fn browser() -> Option<PathBuf> {
    if let Some(named) = std::env::var_os("CROSSFIBRE_BROWSER") {
        return Some(named.into());
    }
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    ["chromium", "chromium-browser", "google-chrome"]
        .iter()
        .flat_map(|name| folders.iter().map(move |folder| folder.join(name)))
        .find(|path| path.is_file())
}

/// Measures the page from within, and leaves what it finds at its end.
const PROBE: &str = r#"<script>
addEventListener('load', async () => {
  const root = document.documentElement;
  await Promise.all([...document.images].map(image => { image.loading = 'eager'; return image.decode(); }));
  const seen = e => e.checkVisibility() && e.getClientRects().length > 0;
  const stops = [...document.querySelectorAll('a[href],summary,input,[tabindex]')].filter(seen);
  const reached = stops.filter(e => { e.focus(); return document.activeElement === e; }).length;
  const slider = document.getElementById('motion-time');
  const line = document.querySelector('.live polyline');
  const before = line.getAttribute('points');
  slider.value = 3;
  slider.dispatchEvent(new Event('input'));
  const corner = image => {
    const canvas = document.createElement('canvas');
    const [width, height] = [canvas.width, canvas.height] = [16, 16];
    const paint = canvas.getContext('2d');
    paint.drawImage(image, 0, 0, width, height);
    return [...paint.getImageData(1, 1, 1, 1).data].join(' ');
  };
  const wide = [...document.querySelectorAll('main *')].filter(e => seen(e)
    && e.getBoundingClientRect().right > innerWidth + 1 && !e.closest('.wide, .hidden'));
  const found = {
    width: innerWidth,
    scroll: root.scrollWidth,
    wide: wide.slice(0, 5).map(e => e.outerHTML.slice(0, 120)),
    stops: stops.length,
    reached,
    forced: stops.filter(e => e.tabIndex > 0).length,
    unnamed: [...document.querySelectorAll('img:not([alt]), img[alt=""], svg:not([aria-label]), [role=region]:not([aria-label])')]
      .length + [...document.querySelectorAll('input')].filter(e => e.labels.length === 0).length,
    fetched: performance.getEntriesByType('resource').map(e => e.name).filter(name => !name.startsWith('data:')),
    moved: line.getAttribute('points') !== before && slider.getAttribute('aria-valuetext'),
    ground: getComputedStyle(document.body).backgroundColor,
    ink: getComputedStyle(document.body).color,
    picture: corner(document.images[0]),
    pictures: document.images.length,
    broken: [...document.images].filter(e => e.naturalWidth === 0).length,
    spilt: [...document.querySelectorAll('summary')].filter(e => seen(e) && [...e.children].some(child =>
      child.getBoundingClientRect().bottom > e.getBoundingClientRect().bottom)).length,
    targets: [...document.querySelectorAll('nav a, summary')].filter(e => seen(e)
      && e.getBoundingClientRect().height < 24).length,
  };
  const pre = document.createElement('pre');
  pre.id = 'probe';
  pre.textContent = JSON.stringify(found);
  document.body.append(pre);
});
</script></body>"#;

/// Opens a page without a window. No name is resolved, so nothing can come from a network.
fn open(browser: &Path, page: &Path, width: u32, scheme: u8, more: &[&str]) -> Output {
    let profile = tempfile::tempdir().unwrap();
    Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"])
        .args(["--enable-logging=stderr", "--virtual-time-budget=20000", "--no-first-run"])
        .arg("--host-resolver-rules=MAP * ~NOTFOUND")
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .arg(format!("--window-size={width},900"))
        .arg(format!("--blink-settings=preferredColorScheme={scheme}"))
        .args(more)
        .arg(format!("file://{}", page.display()))
        .output()
        .unwrap()
}

/// What the probe has found, and what the console says.
fn probed(browser: &Path, page: &Path, width: u32, scheme: u8) -> (Value, Vec<String>) {
    let output = open(browser, page, width, scheme, &["--dump-dom"]);
    let dom = String::from_utf8_lossy(&output.stdout);
    let stderr = String::from_utf8_lossy(&output.stderr);
    let found = dom.split("<pre id=\"probe\">").nth(1).and_then(|rest| rest.split("</pre>").next());
    let found = found.unwrap_or_else(|| panic!("the probe has left nothing: {stderr}"));
    let found = found.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
    let console = stderr.lines().filter(|line| line.contains("CONSOLE")).map(str::to_owned);
    (serde_json::from_str(&found).unwrap(), console.collect())
}

#[test]
fn the_page_is_read_in_both_schemes_at_both_widths_by_keyboard_and_without_a_network() {
    let Some(browser) = browser() else {
        println!("skipped: no browser is installed; CROSSFIBRE_BROWSER names one");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let page = html::render(&report_support::record());
    let [plain, with_probe] = ["report.html", "probe.html"].map(|name| folder.path().join(name));
    fs::write(&plain, &page).unwrap();
    fs::write(&with_probe, page.replace("</body>", PROBE)).unwrap();

    const DARK: u8 = 0;
    const LIGHT: u8 = 1;
    for width in [360, 1280] {
        let grounds = [LIGHT, DARK].map(|scheme| {
            let (found, console) = probed(&browser, &with_probe, width, scheme);
            let number =
                |name: &str| found[name].as_u64().unwrap_or_else(|| panic!("{name}: {found}"));
            assert!(console.is_empty(), "{console:?}");
            // A window narrower than some browsers make it is as narrow as they do.
            assert!(number("width") <= u64::from(width.max(500)), "{found}");
            assert!(number("scroll") <= number("width"), "wider than {width}: {found}");
            assert_eq!(found["wide"], Value::Array(vec![]), "beyond the edge at {width}: {found}");
            assert!(number("stops") > 50 && number("reached") == number("stops"), "{found}");
            for none in ["forced", "unnamed", "broken", "spilt", "targets"] {
                assert_eq!(number(none), 0, "{none} at {width}: {found}");
            }
            assert_eq!(found["fetched"], Value::Array(vec![]), "{found}");
            assert_eq!(found["moved"], "9.0 µs", "the slider moves nothing: {found}");
            assert!(number("pictures") > 15, "{found}");
            (found["ground"].clone(), found["ink"].clone(), found["picture"].clone())
        });
        assert_ne!(grounds[0].0, grounds[1].0);
        assert_ne!(grounds[0].1, grounds[1].1);
        // The corner of a picture: white, and #16181d; smaller pictures are off by a unit or two.
        let corner = |of: &Value| -> Vec<u32> {
            of.as_str().unwrap().split(' ').map(|part| part.parse().unwrap()).collect()
        };
        let [light, dark] = [0, 1].map(|k: usize| corner(&grounds[k].2));
        assert!(light[..3].iter().all(|&part| part > 250), "a picture on a light page: {light:?}");
        assert!(dark[..3].iter().all(|&part| part < 40), "a picture on a dark page: {dark:?}");
    }
    // On paper everything is there: folds are open and nothing waits for a script.
    let pdf = folder.path().join("report.pdf");
    let to = format!("--print-to-pdf={}", pdf.display());
    open(&browser, &plain, 1280, LIGHT, &[&to, "--no-pdf-header-footer"]);
    assert!(fs::metadata(&pdf).unwrap().len() > 100_000);
}
