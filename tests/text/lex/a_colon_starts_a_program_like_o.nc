O1 (LEX-3: the colon is the other spelling of O)
M98 P2
M30
:0002 (SUB)
#100=1
M99
(finally #100=1)
