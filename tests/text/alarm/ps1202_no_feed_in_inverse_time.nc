O1 (PS1202: F of G94 does not count in G93)
F100
G93
G01 X1. (expect alarm PS1202)
M30
