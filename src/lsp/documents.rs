//! Our own requests about a text that is solved: pictures, the motion, answers as tables, files to save. Every answer has the version of
//! the text.

use super::answers::Session;
use super::asked::TextRequest;
use super::error::Failure;
use super::texts::params;
use crate::editor::{Declared, Picture, Results, Wish};
use gen_lsp_types::TextDocumentIdentifier;
use serde::Deserialize;
use serde_json::{Value, json};

/// What these requests carry.
#[derive(Deserialize)]
struct Asked {
    uri: String,
    #[serde(flatten)]
    wish: Wish,
}

/// The answer to a request of ours; nothing where it is none.
pub fn answer(method: &str, message: &Value, session: &Session<'_>) -> Option<Result<Value, Failure>> {
    let ask: fn(&TextRequest<'_>, &Wish) -> Result<Value, Failure> = match method {
        "assur/picture" => |text, wish| text.picture(wish),
        "assur/motion" => |text, wish| text.motion(wish),
        "assur/report" => |text, _| text.report(),
        "assur/kinds" => |text, _| text.kinds(),
        "assur/draw" => |text, wish| text.drawn(wish),
        "assur/write" => |text, wish| text.file(wish),
        "assur/tutorial" => {
            |text, wish| as_value(text.analysis.tutorial(text.results, wish).map_err(Failure::request)?)
        }
        _ => return None,
    };
    Some(params::<Asked>(message).and_then(|asked| {
        let document = TextDocumentIdentifier { uri: asked.uri.as_str().into() };
        let mut answer = session.of(&document, |text| ask(text, &asked.wish))?;
        answer["version"] = session.texts.version(&asked.uri).into();
        Ok(answer)
    }))
}

impl TextRequest<'_> {
    fn solved(&self) -> Result<&Results, Failure> {
        self.results.ok_or_else(|| Failure::request("the text is not solved".to_owned()))
    }

    /// The mechanism at a position, with the names of all, and where what is drawn is declared.
    fn picture(&self, wish: &Wish) -> Result<Value, Failure> {
        let picture = self.analysis.picture(self.solved()?, wish).map_err(Failure::request)?;
        let Picture { svg, poses, places } = picture;
        Ok(json!({ "svg": svg, "poses": poses, "places": self.declared(&places), "part": wish.part }))
    }

    /// The mechanism in motion, as the player takes it.
    fn motion(&self, wish: &Wish) -> Result<Value, Failure> {
        let moving = self.analysis.motion(self.solved()?, wish).map_err(Failure::request)?;
        let mut answer = as_value(moving)?;
        answer["declared"] = self.declared(&self.analysis.declared()).into();
        Ok(answer)
    }

    fn report(&self) -> Result<Value, Failure> {
        as_value(self.analysis.report(self.solved()?).map_err(Failure::request)?)
    }

    fn kinds(&self) -> Result<Value, Failure> {
        Ok(json!({ "kinds": self.analysis.kinds(self.solved()?).map_err(Failure::request)? }))
    }

    fn drawn(&self, wish: &Wish) -> Result<Value, Failure> {
        Ok(json!({ "svg": self.analysis.drawn(wish).map_err(Failure::request)? }))
    }

    fn file(&self, wish: &Wish) -> Result<Value, Failure> {
        let written = self.analysis.file(wish).map_err(Failure::request)?;
        Ok(json!({ "name": written.name, "type": written.kind, "text": written.text }))
    }

    fn declared(&self, places: &[Declared]) -> Vec<Value> {
        let place = |place: &Declared| {
            let range = self.range(place.whole);
            json!({ "name": place.name, "class": place.class, "range": range, "line": place.line, "text": place.text })
        };
        places.iter().map(place).collect()
    }
}

fn as_value(answer: impl serde::Serialize) -> Result<Value, Failure> {
    serde_json::to_value(answer).map_err(|_| Failure::internal())
}
