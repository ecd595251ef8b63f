O1 (LEX-31: G00 and G01 share a group, G91 is of another one)
G00 G91 G01 X1. F100 (expect moves: line X1)
X1. (expect moves: line X2)
M30
