O1 (LEX-16: a block of N and comment does nothing but can be found)
GOTO 10
#100=1
N10 (START)
#101=1 (expect #100=null, #101=1)
M30
