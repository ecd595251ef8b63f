(run with: --block-skip 1)
O1 (LEX-22: also N behind the slash is a jump target)
GOTO 10
#100=1
/N10 #101=1
#102=1
M30
(finally #100=null, #101=null, #102=1)
