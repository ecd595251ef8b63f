O1 (LEX-11: GOTO10, LT5, DO1 and END1 are split without blanks)
IF[#1EQ#0]GOTO10
#100=1
N10WHILE[#1LT5]DO1
#1=#1+1
END1
#101=#1 (expect #100=null, #101=5)
M30
