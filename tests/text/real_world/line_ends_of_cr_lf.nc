O1 (LEX-2: CR LF)
G90 G00 X1.

#100=1
M30
(finally #100=1)
(finally moves: rapid X1)
