/**
 * Every command from its arguments to its exit code, lines, tables and reports.
 *
 * <p>Uses {@code app} as a person does. Commands run in this JVM, or in one of their own where the
 * JVM itself is what is looked at.
 */
package org.palpate.endtoend;
