/**
 * Programs that use Palpate as a library. {@code docs/library.md} shows each of them, {@code
 * ExamplesTest} runs them, and {@code DocumentsTest} compares the page with these files.
 *
 * <p>Each class is complete: save it in a file, and run it with {@code java -cp
 * target/palpate.jar}.
 */
package org.palpate.examples;
