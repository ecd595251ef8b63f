O1 (LEX-27: the sign counts, wherever it comes from)
#1=-100
G01 X1. F#1 (expect alarm PS0006)
M30
(finally moves: none)
