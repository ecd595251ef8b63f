O1 (LEX-14: the comment is kept with its block)
#3000=5(NO PROBE) (expect alarm MC3005 says NO PROBE)
M30
