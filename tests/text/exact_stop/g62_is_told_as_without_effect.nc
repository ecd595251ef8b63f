O1 (section 8.1: G62)
G62 G01 X1. F100 (expect assumed: G62)
G61 X2.
G64 X3.
G09 X4.
M30
