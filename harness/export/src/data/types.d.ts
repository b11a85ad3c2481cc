/** What systems of IEC 61131-3 Structured Text have and do, as `stickler data` writes it. */

/**
 * How an answer is known; `chosen` is what Stickler's model of the system gives where no source states anything, and `open` is no answer.
 */
export type Kind = "documented" | "standard" | "recorded" | "measured" | "chosen" | "open";

/** An answer, and the systems that give it. */
export interface Answer {
  /** A typed literal, or a word: `yes`, `no`, `warn`, `open`, `rejected`; of a feature `has`, `lacks`, `open`. */
  answer: string;
  kind: Kind;
  /** A key of `sources`; null where no source states the answer. */
  source: string | null;
  /** Keys of `systems`. A variant is named only where its system has another answer. */
  systems: string[];
}

/** The answers to one question. */
export type Answers = Answer[];

/** Questions by their texts: `REAL_TO_INT(REAL#2.5) : INT`, `implicit(INT,DINT)`, `bits(WORD,%X7)`. */
export type Questions = Record<string, Answers>;

/** A system: a dialect of a product, or of an edition of the standard. */
export interface System {
  name: string;
  about: string | null;
  variant_of: string | null;
  version: string | null;
  edition: number | null;
  /** Without a section: `{section}` and `{anchor}` in an address stand for one. */
  documents: SourceLine[];
  /** The choices of Stickler's model of it: `conversions.rounding`. */
  choices: Record<string, string>;
}

/** A feature of the language. */
export interface FeatureLine {
  title: string;
  /** The tables and rows of IEC 61131-3, by edition. */
  tables: Record<string, string>;
  needs: string[];
  program: string;
  support: Answers;
}

/** A rule of a conversion, as some systems have it. */
export interface RuleLine {
  about: string;
  rule: string;
  systems: string[];
}

/** A conversion function with the types of one of its signatures. */
export interface ConversionLine {
  operands: string[];
  result: string;
  systems: string[];
  rules: RuleLine[];
}

/** A standard function that is no conversion. */
export interface FunctionLine {
  /** The name and the type of each input. */
  inputs: [string, string][];
  /** Whether the last input may be given several times. */
  more: boolean;
  result: string;
  /** A key of `features`. */
  feature: string | null;
}

/** A source with its section. */
export interface SourceLine {
  basis: string;
  title: string;
  publisher: string;
  kind: string;
  relation: string;
  read: string;
  address: string;
}

/** The whole document. */
export interface SupportData {
  version: string;
  systems: Record<string, System>;
  features: Record<string, FeatureLine>;
  conversions: Record<string, ConversionLine[]>;
  functions: Record<string, FunctionLine>;
  questions: Questions;
  sources: Record<string, SourceLine>;
}

declare const data: SupportData;
export default data;
