O1 (LEX-15: the next line is read again)
G00 X1.(ABC Y2.
Y3. (expect moves: rapid X1 Y3)
M30
(finally moves: rapid X1 Y0; rapid X1 Y3)
