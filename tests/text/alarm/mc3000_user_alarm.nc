O1 (MC3000: the program raises it)
#3000=0(SEE TOOL LIST) (expect alarm MC3000 says SEE TOOL LIST)
M30
