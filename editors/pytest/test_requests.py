"""The language server as the client of pytest-lsp sees it: every request once, and what may go wrong. Run by editors/test.sh."""

import asyncio
import json
import os
import subprocess

import pytest
import pytest_lsp
from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

ASSUR = os.environ.get("ASSUR", "assur")
URI = "untitled:engine.mech"
ENGINE = """\
mech 1
mechanism "Engine"
given r = 100 mm
let l = 3.5*r
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B r
link rod B-C l { S (117 mm, 0); mass 2.5 kg at S; inertia 0.0425 kg*m^2 }
link piston { C (0, 0); mass 2.14 kg at C }
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
prismatic D: piston.C - ground.guide
drive crank = 45 deg at 1500 rpm
assemble C ahead of B
balance torque Mb on crank
find Mb
expect Mb = 472.5 N*m
expect Mb = 400 N*m
"""
DOCUMENT = lsp.TextDocumentIdentifier(URI)
WHOLE = lsp.Range(lsp.Position(0, 0), lsp.Position(18, 0))
FORMATTING = lsp.FormattingOptions(tab_size=2, insert_spaces=True)


@pytest_lsp.fixture(config=ClientServerConfig(server_command=[ASSUR, "lsp"]))
async def client(lsp_client: LanguageClient):
    @lsp_client.feature(lsp.WORKSPACE_INLAY_HINT_REFRESH)
    def _(*_):
        return None

    @lsp_client.feature(lsp.WORKSPACE_CODE_LENS_REFRESH)
    def _(*_):
        return None

    @lsp_client.feature("assur/solved")
    def _(*_):
        return None

    told = client_capabilities("visual-studio-code")
    told.text_document.diagnostic = None
    options = {"solved": True}
    await lsp_client.initialize_session(lsp.InitializeParams(capabilities=told, initialization_options=options))
    yield
    await lsp_client.shutdown_session()


@pytest_lsp.fixture(config=ClientServerConfig(server_command=[ASSUR, "lsp"]))
async def asking(lsp_client: LanguageClient):
    """A client that asks for diagnostics."""
    diagnostics = lsp.DiagnosticWorkspaceClientCapabilities(refresh_support=True)
    capabilities = lsp.ClientCapabilities(
        text_document=lsp.TextDocumentClientCapabilities(diagnostic=lsp.DiagnosticClientCapabilities()),
        workspace=lsp.WorkspaceClientCapabilities(diagnostics=diagnostics),
    )
    await lsp_client.initialize_session(lsp.InitializeParams(capabilities=capabilities))
    yield
    await lsp_client.shutdown_session()


def opened(client, text, uri=URI):
    item = lsp.TextDocumentItem(uri=uri, language_id="mech", version=1, text=text)
    client.text_document_did_open(lsp.DidOpenTextDocumentParams(text_document=item))


async def solved(client):
    """An open text, once its answers are known."""
    opened(client, ENGINE)
    while not any("mismatch" in str(d.code) for d in client.diagnostics.get(URI, [])):
        await client.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)


def at(line, character):
    return {"text_document": DOCUMENT, "position": lsp.Position(line, character)}


@pytest.mark.asyncio
async def test_every_request(client):
    await solved(client)
    hover = await client.text_document_hover_async(lsp.HoverParams(**at(15, 5)))
    assert hover.contents.value.endswith("`Mb` = 472.519 N*m")
    places = await client.text_document_definition_async(lsp.DefinitionParams(**at(12, 7)))
    assert [p.range.start.line for p in places] == [5]
    context = lsp.ReferenceContext(include_declaration=True)
    uses = await client.text_document_references_async(lsp.ReferenceParams(**at(12, 7), context=context))
    assert [u.range.start.line for u in uses] == [5, 8, 9, 12, 14]
    marks = await client.text_document_document_highlight_async(lsp.DocumentHighlightParams(**at(12, 7)))
    assert len(marks) == 5
    name = await client.text_document_prepare_rename_async(lsp.PrepareRenameParams(**at(12, 7)))
    assert name.placeholder == "crank"
    edit = await client.text_document_rename_async(lsp.RenameParams(**at(12, 7), new_name="handle"))
    assert len(edit.changes[URI]) == 5
    with pytest.raises(JsonRpcException, match="`rod` is declared twice"):
        await client.text_document_rename_async(lsp.RenameParams(**at(12, 7), new_name="rod"))
    offered = await client.text_document_completion_async(lsp.CompletionParams(**at(12, 6)))
    assert {"crank", "rod", "D"} <= {item.label for item in offered}
    helped = await client.text_document_signature_help_async(lsp.SignatureHelpParams(**at(15, 5)))
    assert helped is None
    asked = lsp.InlayHintParams(text_document=DOCUMENT, range=WHOLE)
    labels = [hint.label for hint in await client.text_document_inlay_hint_async(asked)]
    assert labels[0].startswith("F = 1 · crank") and labels[1:] == ["= 350 mm", "= 472.519 N*m", "✓", "✗ 472.519 N*m"]
    lenses = await client.text_document_code_lens_async(lsp.CodeLensParams(text_document=DOCUMENT))
    assert [lens.command.title for lens in lenses] == ["solve", "1 of 2 expectations fail", "picture"]
    run = lsp.ExecuteCommandParams(command="assur.solve", arguments=[URI])
    assert "472.519" in await client.workspace_execute_command_async(run)
    tokens = await client.text_document_semantic_tokens_full_async(lsp.SemanticTokensParams(text_document=DOCUMENT))
    assert len(tokens.data) % 5 == 0 and list(tokens.data[:5]) == [0, 0, 4, 0, 0]
    again = lsp.SemanticTokensDeltaParams(text_document=DOCUMENT, previous_result_id=tokens.result_id)
    assert (await client.text_document_semantic_tokens_full_delta_async(again)).edits == ()
    chosen = lsp.SelectionRangeParams(text_document=DOCUMENT, positions=[lsp.Position(6, 20)])
    assert (await client.text_document_selection_range_async(chosen))[0].parent is not None
    found = await client.workspace_symbol_async(lsp.WorkspaceSymbolParams(query="cran"))
    assert [symbol.name for symbol in found] == ["crank"]
    symbols = await client.text_document_document_symbol_async(lsp.DocumentSymbolParams(text_document=DOCUMENT))
    assert "rod" in [symbol.name for symbol in symbols]
    assert not await client.text_document_folding_range_async(lsp.FoldingRangeParams(text_document=DOCUMENT))
    typed = lsp.DocumentOnTypeFormattingParams(**at(8, 0), ch="\n", options=FORMATTING)
    assert not await client.text_document_on_type_formatting_async(typed)
    formatting = lsp.DocumentFormattingParams(text_document=DOCUMENT, options=FORMATTING)
    edits = await client.text_document_formatting_async(formatting)
    ranged = lsp.DocumentRangeFormattingParams(text_document=DOCUMENT, range=WHOLE, options=FORMATTING)
    assert await client.text_document_range_formatting_async(ranged) == edits
    actions = lsp.CodeActionParams(text_document=DOCUMENT, range=WHOLE, context=lsp.CodeActionContext(diagnostics=[]))
    titles = [action.title for action in await client.text_document_code_action_async(actions)]
    assert "add `expect Mb = 472.519 N*m`" in titles, titles
    change = lsp.TextDocumentContentChangeWholeDocument(text=ENGINE.replace("link crank", "lnk crank"))
    version = lsp.VersionedTextDocumentIdentifier(uri=URI, version=2)
    client.text_document_did_change(lsp.DidChangeTextDocumentParams(version, [change]))
    await client.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    assert any("link crank A-B r" in d.message for d in client.diagnostics[URI])
    client.text_document_did_close(lsp.DidCloseTextDocumentParams(DOCUMENT))
    await client.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    assert not client.diagnostics[URI]


@pytest.mark.asyncio
async def test_solved(client):
    opened(client, ENGINE)
    told = await client.wait_for_notification("assur/solved")
    assert (told.uri, told.version, told.poses) == (URI, 1, 1)


@pytest.mark.asyncio
async def test_diagnostics_on_request(asking):
    opened(asking, ENGINE)
    params = lsp.DocumentDiagnosticParams(text_document=DOCUMENT)
    for _ in range(200):
        report = await asking.text_document_diagnostic_async(params)
        if report.items:
            break
        await asyncio.sleep(0.1)
    assert [d.code for d in report.items] == ["mech::expect::mismatch"]
    assert not asking.diagnostics


@pytest.mark.asyncio
async def test_bad_places_and_texts(client):
    opened(client, "given φ = 5 mm\n")
    with pytest.raises(JsonRpcException, match="there is no place 99:0"):
        await client.text_document_hover_async(lsp.HoverParams(**at(99, 0)))
    # a column after the end is the end
    assert await client.text_document_hover_async(lsp.HoverParams(**at(0, 999))) is None
    unknown = lsp.TextDocumentIdentifier("untitled:unknown")
    with pytest.raises(JsonRpcException, match="is not open"):
        await client.text_document_code_lens_async(lsp.CodeLensParams(text_document=unknown))
    with pytest.raises(JsonRpcException, match="no command `assur.fly`"):
        run = lsp.ExecuteCommandParams(command="assur.fly", arguments=[URI])
        await client.workspace_execute_command_async(run)
    with pytest.raises(JsonRpcException, match="there is no name here"):
        await client.text_document_prepare_rename_async(lsp.PrepareRenameParams(**at(0, 1)))


def framed(message):
    body = message if isinstance(message, bytes) else json.dumps(message).encode()
    return b"Content-Length: %d\r\n\r\n%s" % (len(body), body)


def call(number, method, params=None):
    return {"jsonrpc": "2.0", "id": number, "method": method, "params": params or {}}


def test_broken_and_cancelled_messages():
    said = [
        framed(call(1, "initialize", {"capabilities": {}})),
        framed(b'{"jsonrpc": "2.0", "id": '),
        framed({"jsonrpc": "2.0", "method": "$/cancelRequest", "params": {"id": 1}}),
        framed(call(2, "workspace/symbol", {"query": ""})),
        framed({"jsonrpc": "2.0", "method": "$/cancelRequest", "params": {"id": 2}}),
        framed(call(3, "textDocument/hover", {"position": "nowhere"})),
        framed(call(4, "shutdown")),
        framed({"jsonrpc": "2.0", "method": "exit"}),
    ]
    done = subprocess.run([ASSUR, "lsp"], input=b"".join(said), capture_output=True, timeout=20, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    bodies = [part.split(b"\r\n\r\n", 1)[1] for part in done.stdout.split(b"Content-Length: ")[1:]]
    answers = [json.loads(body) for body in bodies]
    assert [answer.get("id") for answer in answers] == [1, None, 2, 3, 4]
    assert [answer.get("error", {}).get("code") for answer in answers] == [None, -32700, None, -32602, None]
