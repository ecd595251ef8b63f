O1 (#3000= 15 and a text with punctuation)
#3000= 15 (TOOL LENGTH? / SEE "SHEET 2".) (expect alarm MC3015 says TOOL LENGTH? / SEE "SHEET 2".)
M30
