O1 (LEX-23: all four forms of a word)
#1=3
G90 G00 X-[#1+2.] (expect moves: rapid X-5)
Y-#1 (expect moves: rapid Y-3)
X#1 Y[#1] (expect moves: rapid X3 Y3)
M30
