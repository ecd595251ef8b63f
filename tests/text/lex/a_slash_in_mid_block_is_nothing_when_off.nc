O1 (LEX-19: with switch 2 off all words are read)
G00 X1. /2 Y1. (expect moves: rapid X1 Y1)
M30
