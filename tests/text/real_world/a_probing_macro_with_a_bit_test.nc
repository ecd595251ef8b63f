(run with: --set #1004=1)
O1 (inputs decide whether to go on)
IF[#1004EQ0]GOTO9
IF[#1032AND16EQ16]GOTO5
#100=1
N5 #101=1
N9 M30
(finally #100=null, #101=1)
