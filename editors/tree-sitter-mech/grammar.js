/// <reference types="tree-sitter-cli/dsl" />
// The grammar of `.mech`, after grammar/mech.pest: texts without slips.

const LETTER = '\\p{L}\\p{Nl}';
const MORE = `[${LETTER}\\p{Mn}\\p{Mc}\\p{Nd}\\p{Pc}'₀-₉]`;

// Newlines that end nothing: after an opening bracket, a comma or an operator, and before a closing bracket.
const nl = ($) => repeat($._newline);
const list = ($, rule) => seq(rule, repeat(seq(',', nl($), rule)));
// Items in braces, each ended by a newline or `;`.
const braces = ($, item) => seq('{', optional($._end), optional(seq(item, repeat(seq($._end, item)), optional($._end))), '}');
const minus = choice('-', '−', '–');

module.exports = grammar({
  name: 'mech',

  externals: ($) => [$.unit, $._error_sentinel],
  extras: ($) => [/[ \t\u00a0\ufeff]/, $.comment],
  word: ($) => $.identifier,
  supertypes: ($) => [$.statement, $.member, $.cam_member, $.expression],

  rules: {
    source_file: ($) => seq(optional($._end), optional(seq($.statement, repeat(seq($._end, $.statement)), optional($._end)))),

    statement: ($) =>
      choice(
        $.edition, $.title, $.given, $.let, $.gravity, $.ground, $.link, $.shaft, $.slider, $.pair, $.spring, $.all, $.group,
        $.drive, $.pose, $.assemble, $.load, $.balance, $.cam, $.brake, $.flywheel, $.counterweight, $.start, $.equilibrium, $.simulate, $.event, $.until,
        $.stop, $.ignore, $.find, $.expect, $.curve, $.variants,
      ),

    // ---------------------------------------------------------------------------------------- the head, and values

    edition: ($) => seq('mech', $.number),
    title: ($) => seq('mechanism', $.string),
    given: ($) => seq('given', field('name', $.identifier), '=', nl($), $.expression),
    let: ($) => seq('let', field('name', $.identifier), '=', nl($), $.expression),
    gravity: ($) => seq('gravity', $.expression),

    // ------------------------------------------------------------------------------------------------------- links

    ground: ($) => seq('ground', optional($.number), $.body),
    link: ($) => seq('link', optional($.number), field('name', $.identifier), optional($.bar), optional($.body)),
    bar: ($) => seq($.identifier, minus, nl($), $.identifier, $.expression),
    shaft: ($) => seq('shaft', field('name', $.identifier), optional(seq('on', $.identifier)), optional($.body)),
    slider: ($) => seq('slider', field('name', $.identifier), optional($.body)),

    body: ($) => braces($, $.member),
    member: ($) => choice($.line, $.circle, $.profile, $.mass, $.weight, $.inertia, $.plane, $.wheel, $.point),
    line: ($) =>
      seq('line', field('name', $.identifier), 'through', $.identifier, choice(seq('along', $.expression), seq('to', $.identifier))),
    circle: ($) => seq('circle', field('name', $.identifier), 'centre', $.identifier, 'radius', $.expression),
    profile: ($) => seq('profile', field('name', $.identifier), 'of', $.identifier, 'centre', $.identifier),
    mass: ($) =>
      seq('mass', $.expression, optional(choice(seq('at', $.identifier), $.shape)), optional(seq('inertia', $.expression)), optional($.plane)),
    weight: ($) =>
      seq('weight', $.expression, optional(choice(seq('at', $.identifier), $.shape)), optional(seq('inertia', $.expression)), optional($.plane)),
    plane: ($) => seq('plane', $.expression),
    shape: ($) =>
      seq(
        choice(
          seq('rod', $.identifier, 'to', $.identifier),
          seq(
            choice('disc', 'ring', 'sphere'), 'centre', $.identifier, 'radius', $.expression,
            optional(seq('inner', $.expression)),
          ),
          seq('plate', $.identifier, repeat1(seq(',', nl($), $.identifier))),
        ),
        optional(seq(choice('thickness', 'section'), $.expression)),
      ),
    inertia: ($) => seq('inertia', $.expression, optional(seq('about', $.identifier))),
    wheel: ($) =>
      seq(
        'wheel',
        field('name', $.identifier),
        optional(seq(choice('radius', 'diameter', 'teeth'), $.expression)),
        optional(seq('module', $.expression)),
        optional(seq('at', $.identifier)),
      ),
    point: ($) =>
      seq(
        field('name', $.identifier),
        $.expression,
        optional(choice(seq('at', $.expression), seq('from', $.identifier, $.expression, 'from', $.identifier, $.side))),
      ),
    side: () => choice('left', 'right'),

    // ------------------------------------------------------------------------------------------------------- pairs

    pair: ($) =>
      seq($.kind, field('name', $.identifier), ':', nl($), $._part, repeat1(seq(minus, nl($), $._part)), optional($.properties)),
    kind: () =>
      choice(
        'revolute', 'prismatic', 'slot', 'contact', 'cylinder', 'mesh', 'rope', 'belt', 'chain', 'rack', 'worm', 'screw', 'clutch', 'weld',
      ),
    _part: ($) => choice($.path, $.pulley),
    pulley: ($) => seq(choice('over', 'under'), '(', $.identifier, ')'),
    path: ($) => seq($.identifier, optional(seq('.', field('part', $.identifier)))),
    spring: ($) =>
      seq(
        'spring',
        field('name', $.identifier),
        choice(seq('in', $.identifier), seq(':', nl($), $.path, minus, nl($), $.path)),
        optional($.properties),
      ),
    all: ($) => seq('all', $.kind, $.properties),
    group: ($) => seq('group', field('name', $.identifier), ':', nl($), list($, $.identifier)),
    properties: ($) => braces($, $.property),
    property: ($) => seq(field('name', choice($.identifier, 'module')), optional(choice(list($, $.expression), $.turn)), optional($.properties)),

    // ---------------------------------------------------------------------------------------- drives and assemblies

    drive: ($) => seq('drive', $.path, optional(seq('=', nl($), $._position)), optional($.rate), optional($.acceleration), optional($.direction)),
    _position: ($) => seq($._sensed, choice($.course, repeat(seq(',', nl($), $._sensed)))),
    course: ($) => seq('..', nl($), $.expression, choice($._in_steps, seq('step', $.expression))),
    _in_steps: ($) => seq('in', $.expression, 'steps'),
    rate: ($) => seq('at', $._sensed),
    acceleration: ($) => seq('accelerating', $._sensed),
    direction: ($) => choice(seq('turning', $.turn), seq('moving', choice('forward', 'back'))),
    turn: () => choice('ccw', 'cw'),
    _sensed: ($) => seq($.expression, optional($.turn)),
    pose: ($) => seq('pose', field('name', $.pose_name), 'at', list($, $.setting)),
    setting: ($) => seq($.path, '=', nl($), $._sensed),
    assemble: ($) => seq('assemble', list($, $.clause)),
    clause: ($) =>
      seq(
        $.path,
        choice(
          seq(choice('near', 'phase'), $.expression),
          seq($.side, 'of', $.path, minus, $.path),
          seq(choice(seq('ahead', 'of'), 'behind'), $.path),
          seq($._comparison, nl($), $.expression),
        ),
      ),
    _comparison: () => choice('<=', '>=', '<', '>'),

    // ------------------------------------------------------------------------------------------ loads and elements

    load: ($) =>
      seq(
        choice('force', 'torque'),
        field('name', optional($.identifier)),
        $._site,
        '=',
        nl($),
        $._sensed,
        optional(seq('..', nl($), $.expression)),
        optional($.heading),
        optional($.frame),
        optional(seq('against', 'motion')),
        optional(seq('when', $.expression)),
      ),
    _site: ($) => choice(seq('in', $.identifier), seq('at', $.identifier), seq('on', $.identifier, optional(choice(seq('at', choice($.parenthesized, $.identifier)), seq('from', $.identifier, 'to', $.identifier))))),
    heading: () => choice('left', 'right', 'up', 'down'),
    frame: ($) => seq('in', $.identifier),
    balance: ($) =>
      seq(
        'balance',
        choice('force', 'torque'),
        field('name', $.identifier),
        $._site,
        repeat(seq(',', nl($), $.identifier)),
        optional(seq('along', choice($.heading, $.expression))),
        optional($.frame),
      ),
    cam: ($) => seq('cam', field('name', $.identifier), braces($, $.cam_member)),
    cam_member: ($) => choice($.turning, $.follower, $.cam_phase, $.lift, $.property),
    turning: ($) => seq('turning', $.turn),
    follower: ($) => seq('follower', $.identifier, $.identifier, optional($.properties)),
    cam_phase: ($) => seq(choice('rise', 'dwell', 'fall'), $.expression, optional(seq('through', $.expression)), optional($.law)),
    lift: ($) => seq('lift', 'along', $.identifier),
    law: () =>
      choice('parabolic', 'harmonic', 'cycloidal', 'poly345', 'poly4567', 'modified_trapezoid', 'modified_sine', 'uniform'),
    brake: ($) => seq('brake', field('name', $.identifier), 'on', $.identifier, optional($.properties)),
    counterweight: ($) => seq('counterweight', field('name', $.identifier), 'on', $.identifier, optional($.properties)),
    flywheel: ($) =>
      seq('flywheel', field('name', $.identifier), 'on', $.identifier, optional(seq('for', $.identifier)), optional($.properties)),

    // ------------------------------------------------------------------------------------------ motion under loads

    start: ($) => seq('start', $.path, choice(seq('=', nl($), $._sensed, optional($.rate)), $.rate)),
    equilibrium: ($) => seq('equilibrium', $._balanced, repeat(seq(',', nl($), $._balanced))),
    _balanced: ($) =>
      seq(
        $.path,
        optional(choice(seq('near', $.expression), seq('in', $.expression, '..', nl($), $.expression))),
        optional($.rate),
      ),
    simulate: ($) =>
      seq(
        'simulate',
        choice($.steady, seq($.expression, optional(seq('..', nl($), $.expression)))),
        optional($._in_steps),
        optional($.within),
      ),
    steady: ($) => seq('steady', choice('cycle', seq(optional($.number), choice('turns', 'turn'))), 'of', $.path),
    event: ($) => seq('event', field('name', $.identifier), ':', nl($), $._passing),
    until: ($) => seq('until', $._passing),
    _passing: ($) => seq($.expression, optional(seq('=', nl($), $.expression)), optional(choice('rising', 'falling'))),
    stop: ($) => seq('stop', $.identifier, $._comparison, nl($), $.expression, optional($.properties)),
    ignore: ($) => seq('ignore', $.identifier),

    // -------------------------------------------------------------------------------------------- find and expect

    find: ($) => seq('find', nl($), list($, $.answer)),
    answer: ($) =>
      seq(optional(seq(field('name', $.identifier), '=', nl($))), $.expression, optional($._in_steps), optional(seq('as', $.unit))),
    expect: ($) =>
      seq(
        'expect',
        $.expression,
        optional(seq('=', nl($), list($, $.expression))),
        optional($.within),
        optional(seq('at', choice($.at_pose, $.at_event, list($, $.setting)))),
      ),
    within: ($) => seq('within', $.expression),
    at_pose: ($) => seq('pose', $.pose_name),
    at_event: ($) => seq('event', $.identifier, optional($.number)),

    // ------------------------------------------------------------------------------------------------------ tables

    curve: ($) =>
      seq(
        'curve',
        field('name', $.identifier),
        optional(choice('linear', 'smooth')),
        optional(choice('periodic', 'held')),
        $.table,
      ),
    variants: ($) => seq('variants', $.table),
    table: ($) =>
      seq('{', optional($._end), optional(seq($.header, repeat(seq($._end, $.row)), optional($._end))), '}'),
    header: ($) => list($, $.column),
    column: ($) => seq($.identifier, optional(seq('[', $.unit, ']'))),
    row: ($) => list($, $._cell),
    _cell: ($) => choice(seq(optional(choice('+', minus)), $.quantity), $.row_name, $.string),

    // ------------------------------------------------------------------------------------------------- expressions

    // From the loosest to the tightest.
    expression: ($) => choice($.binary, $.unary, $.quantity, $.parenthesized, $.call, $.member_of, alias($.identifier, $.name)),
    binary: ($) => {
      const levels = [['or'], ['and'], ['<=', '>=', '<', '>'], ['+', '-', '−', '–'], ['@'], ['*', '/', '·', '⋅']];
      const tiers = [1, 2, 4, 5, 6, 7];
      return choice(
        ...levels.map((signs, i) => prec.left(tiers[i], seq($.expression, signs.length > 1 ? choice(...signs) : signs[0], nl($), $.expression))),
        prec.right(9, seq($.expression, '^', nl($), $.expression)),
      );
    },
    unary: ($) => choice(prec(3, seq('not', $.expression)), prec(8, seq(choice('+', minus), $.expression))),
    quantity: ($) => prec.right(seq($.number, optional($.unit))),
    // A value, or a vector by its components.
    parenthesized: ($) => seq('(', nl($), $.expression, nl($), optional(seq(',', nl($), $.expression, nl($))), ')'),
    call: ($) => prec(11, seq(field('function', $.identifier), '(', nl($), optional($._arguments), ')')),
    _arguments: ($) => seq($._argument, nl($), repeat(seq(',', nl($), $._argument, nl($)))),
    _argument: ($) => choice($.named_argument, $.expression),
    named_argument: ($) => seq(field('name', $.identifier), '=', nl($), $.expression),
    member_of: ($) => prec(10, seq($.expression, '.', field('part', $.identifier))),

    // ------------------------------------------------------------------------------------------------------ tokens

    _end: ($) => repeat1(choice($._newline, ';')),
    _newline: () => /\r?\n|\r/,
    comment: () => token(seq('//', /[^\r\n]*/)),
    string: () => /"[^"\r\n]*"/,
    number: () => /[0-9]+(\.[0-9]+)?([eE][+−-]?[0-9]+)?/,
    identifier: () => new RegExp(`[${LETTER}]${MORE}*`),
    // `4'`
    pose_name: () => new RegExp(`[${LETTER}0-9]${MORE}*`),
    // `B-2`
    row_name: () => new RegExp(`[${LETTER}](${MORE}|[.-])*`),
  },
});
