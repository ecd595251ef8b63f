O1 (LEX-27: a minus, wherever P stands)
G00 X1. P-1 (expect alarm PS0006 at P-1)
M30
