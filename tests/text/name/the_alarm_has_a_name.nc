O1 (section 3.1: #_ALM is #3000)
[#_ALM]=7(BY NAME) (expect alarm MC3007 says BY NAME)
M30
