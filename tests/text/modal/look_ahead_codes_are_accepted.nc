O1 (section 8.1: G05.1 and G08)
G05.1 Q1
G08 P1
G01 X1. F100 (expect moves: line X1)
G08 P0
G05.1 Q0
M30
