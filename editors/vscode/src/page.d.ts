declare module "*.html" {
  const text: string;
  export default text;
}

declare module "*/player.js" {
  const text: string;
  export default text;
}

declare module "*/player.css" {
  const text: string;
  export default text;
}
