// The words of the page itself, in three languages. What is said of mechanisms comes from the program.

export const LANGUAGES = ["en", "ru", "zh"] as const;
export type Language = (typeof LANGUAGES)[number];

const WORDS = {
  name: ["English", "Русский", "中文"],
  language: ["Language", "Язык", "语言"],
  examples: ["Examples", "Примеры", "示例"],
  tutorial: ["Tutorial", "Урок", "教程"],
  share: ["Share", "Поделиться", "分享"],
  save: ["Save", "Сохранить", "保存"],
  open: ["Open", "Открыть", "打开"],
  help: ["Keys", "Клавиши", "按键"],
  docs: ["Docs", "Справка", "文档"],
  text: ["Text", "Текст", "文本"],
  answers: ["Answers", "Ответы", "答案"],
  worked: ["Worked solution", "Решение", "解题过程"],
  pictures: ["Pictures", "Рисунки", "图"],
  problems: ["Problems", "Замечания", "问题"],
  editor: ["The text of the mechanism", "Текст механизма", "机构文本"],
  picture: ["The mechanism", "Механизм", "机构"],
  ok: ["ok", "верно", "正确"],
  works: ["solving…", "решается…", "求解中…"],
  loading: ["loading…", "загрузка…", "加载中…"],
  oneError: ["1 error", "1 ошибка", "1 个错误"],
  errors: ["{} errors", "ошибок: {}", "{} 个错误"],
  line: ["line {}", "строка {}", "第 {} 行"],
  none: ["No problems.", "Замечаний нет.", "没有问题。"],
  go: ["Go to the line", "К строке", "转到该行"],
  old: ["Below is the last good picture.", "Ниже последний верный рисунок.", "下面是上一个正确的图。"],
  nothing: ["There are no answers yet.", "Ответов пока нет.", "还没有答案。"],
  rows: ["{} of {} rows", "Строк: {} из {}", "{} / {} 行"],
  more: ["Show {} more", "Показать ещё {}", "再显示 {} 行"],
  late: [
    "This takes longer than 5 s in the browser. `assur solve FILE` has no limit.",
    "Это длится в браузере больше 5 с. У команды `assur solve FILE` нет предела.",
    "在浏览器中超过 5 秒。命令 `assur solve FILE` 没有时间限制。",
  ],
  again: ["Try 60 s", "Ждать 60 с", "再试 60 秒"],
  failed: [
    "The program cannot be loaded here: {}",
    "Программу не удалось загрузить: {}",
    "无法加载程序：{}",
  ],
  print: ["Print", "Печать", "打印"],
  close: ["Close", "Закрыть", "关闭"],
  search: ["Search all examples", "Поиск по всем примерам", "搜索全部示例"],
  found: ["{} found", "найдено: {}", "找到 {} 个"],
  missing: ["There is no example of this name.", "Примера с таким именем нет.", "没有这个名称的示例。"],
  texts: ["My texts", "Мои тексты", "我的文本"],
  mine: ["Back to my text", "К моему тексту", "回到我的文本"],
  broken: [
    "This link is not complete: its text cannot be read. The address is kept, so that you can copy it.",
    "Ссылка неполная: текст не читается. Адрес сохранён, его можно скопировать.",
    "链接不完整，无法读取其中的文本。地址已保留，可以复制。",
  ],
  newer: [
    "This link was made by a newer playground. Its address is kept, so that you can copy it.",
    "Ссылка сделана более новой версией. Адрес сохранён, его можно скопировать.",
    "此链接由更新的版本生成。地址已保留，可以复制。",
  ],
  version: ["Made with {}; this is {}.", "Сделано в версии {}; здесь {}.", "由 {} 生成；当前为 {}。"],
  link: ["Link", "Ссылка", "链接"],
  copy: ["Copy", "Копировать", "复制"],
  copied: ["copied", "скопировано", "已复制"],
  short: ["{} characters: it fits everywhere.", "Знаков: {}. Подходит везде.", "{} 个字符：可在任何地方使用。"],
  long: [
    "{} characters: some programs cut links of this length.",
    "Знаков: {}. Некоторые программы обрезают такие ссылки.",
    "{} 个字符：有些程序会截断这样长的链接。",
  ],
  huge: ["{} characters: send the file instead.", "Знаков: {}. Лучше отправить файл.", "{} 个字符：请发送文件。"],
  page: ["HTML for a course page", "HTML для страницы курса", "课程页面的 HTML"],
  playground: ["Open in the playground", "Открыть на площадке", "在演练场中打开"],
  file: ["The text (.mech)", "Текст (.mech)", "文本 (.mech)"],
  svg: ["Picture (SVG)", "Рисунок (SVG)", "图 (SVG)"],
  png: ["Picture (PNG)", "Рисунок (PNG)", "图 (PNG)"],
  csv: ["Table of positions (CSV)", "Таблица положений (CSV)", "位置表 (CSV)"],
  json: ["All answers (JSON)", "Все ответы (JSON)", "全部答案 (JSON)"],
  html: ["Worked solution (HTML)", "Решение (HTML)", "解题过程 (HTML)"],
  sheet: ["Exercise sheet (HTML)", "Лист задания (HTML)", "练习题 (HTML)"],
  key: ["Key (HTML)", "Ключ (HTML)", "答案 (HTML)"],
  motion: ["Motion (HTML)", "Движение (HTML)", "运动 (HTML)"],
  write: ["Write these lines for me", "Вставить эти строки", "替我写入这些行"],
  done: ["done", "готово", "完成"],
  finished: [
    "All six steps are done. Change a number and watch the answers.",
    "Все шесть шагов пройдены. Измените число и посмотрите на ответы.",
    "六步全部完成。改动一个数，看看答案如何变化。",
  ],
  leave: ["Leave the tutorial", "Выйти из урока", "退出教程"],
  dropped: ["The file is longer than 1 MB.", "Файл больше 1 МБ.", "文件超过 1 MB。"],
} satisfies Record<string, [string, string, string]>;

export type Word = keyof typeof WORDS;

/** A word, with parts in its places. */
export function word(language: Language, key: Word, ...parts: (string | number)[]): string {
  const texts: readonly string[] = WORDS[key];
  let at = 0;
  return texts[LANGUAGES.indexOf(language)].replaceAll("{}", () => String(parts[at++] ?? ""));
}

/** The language that the browser prefers among those there are. */
export function preferred(): Language {
  const found = navigator.languages.map((one) => one.slice(0, 2)).find((one) => LANGUAGES.some((own) => own === one));
  return (found as Language | undefined) ?? "en";
}

/** The keys that the page knows, with what they do. */
export const KEYS: [string, [string, string, string]][] = [
  ["Ctrl+K", ["examples", "примеры", "示例"]],
  ["Ctrl+S", ["save", "сохранить", "保存"]],
  ["Ctrl+.", ["problems and their corrections", "замечания и исправления", "问题与修正"]],
  ["F8", ["next problem", "следующее замечание", "下一个问题"]],
  ["Shift+Alt+F", ["format the text", "оформить текст", "格式化文本"]],
  ["F2", ["another name", "другое имя", "重命名"]],
  ["F12", ["where a name is declared", "где объявлено имя", "转到声明处"]],
  ["Ctrl+Space", ["what can be written here", "что можно написать здесь", "可以写什么"]],
  ["Alt+1 … 5", ["answers, worked solution, pictures, problems, tutorial", "ответы, решение, рисунки, замечания, урок", "答案、解题过程、图、问题、教程"]],
  ["Space, ← →, [ ]", ["play, one frame (on the picture)", "пуск, один кадр (на рисунке)", "播放，单帧（在图上）"]],
  ["Esc, Tab", ["leave the editor", "выйти из редактора", "离开编辑器"]],
  ["?", ["this list", "этот список", "此列表"]],
];
