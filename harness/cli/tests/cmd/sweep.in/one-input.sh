# The reference, with one of 65,536 inputs of INT_TO_SINT wrong.
sed -u 's/:= INT_TO_SINT(operand)/& + BOOL_TO_SINT(operand = INT#4711)/g' | stickler engine
