O1 (the text is shown with its stars)
#3000=91(XYZ*INPUT*MISSING) (expect alarm MC3091 says XYZ*INPUT*MISSING)
M30
