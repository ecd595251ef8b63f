O1 (MOD360, AND4EQ4, GOTO9 and N7 glued to the next word)
#33=750
#32=#33MOD360 (expect #32=30)
#120=5
IF[#120AND4EQ4]GOTO9
#100=1
N9G90G0X#32Y-#32 (expect moves: rapid X30 Y-30)
#101=1 (expect #100=null, #101=1)
M30
