goto foo ' (expect alarm LB0006 column 6 says undefined label)
