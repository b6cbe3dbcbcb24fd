declare module "*.mech" {
  const text: string;
  export default text;
}

/** The version of the program, put in by build.mjs. */
declare const VERSION: string;
